#include "display/bayer.h"

#include <span>

#include "display/threshold_tile.h"

namespace emulsion {

void quantize(const Bayer& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    ThresholdTile tile{dither.size, dither.size, {}};
    for (int y = 0; y < dither.size; ++y) {
        for (int x = 0; x < dither.size; ++x) {
            tile.thresholds.push_back(threshold_of_rank(bayer_rank(x, y, dither.size), dither.size * dither.size));
        }
    }
    quantize_by_tiles(std::span(&tile, 1), encoded, scale, codes, threads);
}

}  // namespace emulsion
