#include "display/no_dither.h"

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/row_blocks.h"

namespace emulsion {

namespace {

std::uint16_t nearest_code(float encoded, const CodeScale& scale) noexcept {
    const double steps = static_cast<double>(unit_clamp(encoded)) * scale.steps();
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): not negative, and exact in double precision up to the cut
    return static_cast<std::uint16_t>(scale.black + static_cast<int>(steps + 0.5));
}

}  // namespace

void quantize(const NoDither& /*dither*/, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    parallel_for_rows(encoded.width, encoded.height, threads, [&](int y) {
        const std::span<const float> in = encoded.row(y);
        const std::span<std::uint16_t> out = codes.row(y);
        for (std::size_t i = 0; i < in.size(); ++i) out[i] = nearest_code(in[i], scale);
    });
}

}  // namespace emulsion
