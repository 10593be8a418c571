#pragma once
// Error diffusion as it is written, one channel and one pixel at a time: what the fast one is to be the same as.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "display/code_units.h"
#include "display/component_rows.h"
#include "display/diffusion_kernel.h"

namespace emulsion {

/// Which way rows are taken.
enum class RowOrder { raster, serpentine };

/// 1 if row y is taken from the left, -1 if from the right.
[[nodiscard]] constexpr int row_direction(RowOrder order, int y) noexcept {
    return order == RowOrder::serpentine && y % 2 != 0 ? -1 : 1;
}

/// Rounds to the nearest code that there is, and leaves the error in `value`, which is in units.
template <class Int>
[[nodiscard]] constexpr std::uint16_t take_code(Int& value, const CodeUnits& units, const CodeScale& scale) noexcept {
    const Int nearest = (value + units.per_code() / 2) >> units.fraction_bits();
    const Int step = nearest < 0 ? 0 : nearest > scale.steps() ? static_cast<Int>(scale.steps()) : nearest;
    value -= step << units.fraction_bits();
    return static_cast<std::uint16_t>(scale.black + step);
}

/// The errors that have reached pixels of a row and the two below it, of one channel. 64 bits: where a picture is
/// saturated down to its last row, errors add up in that.
class IncomingErrors {
  public:
    explicit IncomingErrors(int width) : width_(static_cast<std::size_t>(width)), errors_(3 * width_) {}
    [[nodiscard]] std::span<std::int64_t> row(int y) noexcept {
        return std::span(errors_).subspan(static_cast<std::size_t>(y % 3) * width_, width_);
    }

  private:
    std::size_t width_;
    std::vector<std::int64_t> errors_;
};

/// Rounds one channel of a picture's last rows, on one thread: those from `first_row` on are what `encoded` and `codes`
/// have. `incoming` is what has reached them from the rows above, row 0 the first of them.
void diffuse_plainly(const DiffusionKernel& kernel, RowOrder order, const EncodedRows& encoded, const CodeScale& scale,
                     const CodeRows& codes, int channel, int first_row, IncomingErrors& incoming);

/// Rounds all of all channels of a whole picture.
void diffuse_plainly(const DiffusionKernel& kernel, RowOrder order, const EncodedRows& encoded, const CodeScale& scale,
                     const CodeRows& codes);

}  // namespace emulsion
