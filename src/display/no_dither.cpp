#include "display/no_dither.h"

#include <cstddef>
#include <span>

#include "core/row_blocks.h"

namespace emulsion {

namespace {

std::uint8_t nearest_code(float encoded) noexcept {
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): not negative, and exact in double precision up to the cut
    return static_cast<std::uint8_t>(static_cast<double>(unit_clamp(encoded)) * kMaxCode + 0.5);
}

}  // namespace

void quantize(const NoDither& /*dither*/, ImageView<const RGB> encoded, ImageView<CodeRGB> codes, int threads) {
    parallel_for_rows(encoded.width(), encoded.height(), threads, [&](int y) {
        const std::span<const RGB> in = encoded.row(y);
        const std::span<CodeRGB> out = codes.row(y);
        for (std::size_t x = 0; x < in.size(); ++x) {
            out[x] = {nearest_code(in[x].r), nearest_code(in[x].g), nearest_code(in[x].b)};
        }
    });
}

}  // namespace emulsion
