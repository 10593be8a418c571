#include "display/no_dither.h"

#include <cstddef>
#include <span>

#include "core/row_blocks.h"

namespace emulsion {

namespace {

std::uint16_t nearest_code(float encoded, const CodeScale& scale) noexcept {
    // Not negative, and exact in double precision up to the cut.
    const double steps = static_cast<double>(unit_clamp(encoded)) * scale.steps();
    return static_cast<std::uint16_t>(scale.black + static_cast<int>(steps + 0.5));
}

}  // namespace

void quantize(const NoDither& /*dither*/, ImageView<const RGB> encoded, const CodeScale& scale,
              ImageView<CodeRGB> codes, int threads) {
    parallel_for_rows(encoded.width(), encoded.height(), threads, [&](int y) {
        const std::span<const RGB> in = encoded.row(y);
        const std::span<CodeRGB> out = codes.row(y);
        for (std::size_t x = 0; x < in.size(); ++x) {
            out[x] = {nearest_code(in[x].r, scale), nearest_code(in[x].g, scale), nearest_code(in[x].b, scale)};
        }
    });
}

}  // namespace emulsion
