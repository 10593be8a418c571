#include "display/no_dither.h"

#include <cstddef>
#include <span>

#include "display/code_rows.h"

namespace emulsion {

void quantize(const NoDither& /*dither*/, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    for_each_stretch(source, threads, [&] {
        return [&](int y, int x0, std::span<const float> encoded) {
            const std::size_t begin = static_cast<std::size_t>(x0) * static_cast<std::size_t>(codes.channels);
            round_to_nearest(encoded, scale, codes.row(y).subspan(begin, encoded.size()));
        };
    });
}

}  // namespace emulsion
