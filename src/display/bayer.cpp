#include "display/bayer.h"

#include <cstddef>
#include <vector>

#include "display/threshold_rows.h"

namespace emulsion {

void quantize(const Bayer& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    const int size = dither.size;
    std::vector<Threshold> tile;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            tile.insert(tile.end(), static_cast<std::size_t>(source.channels()),
                        threshold_of_rank(bayer_rank(x, y, size), size * size));
        }
    }
    quantize_by_tile(tile, size, source, scale, codes, threads);
}

}  // namespace emulsion
