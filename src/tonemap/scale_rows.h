#pragma once
// The inner loops of the pointwise fast path: rows of pixels times a scale each, in vectors as wide as the processor
// has. The same bits for every width.

#include <cstddef>
#include <span>
#include <vector>

#include "core/color.h"
#include "tonemap/luminance_table.h"

namespace emulsion {

/// x of the pixels of a row that these loops leave as they are: where Y < 0, or a component of the product would be NaN
/// or past kMaxDisplayComponent.
using LeftPixels = std::vector<std::size_t>;

/// What is known of the pixels before they are scaled. Plain: none needs to be left.
enum class RowPixels { any, plain };

/// Components of a tone-mapped pixel stay within this, so that later stages don't overflow.
inline constexpr double kMaxDisplayComponent = 0x1p100;

/// out[x] = scale * in[x], or in[x] where that cannot be: those x are appended to `left`, in rising order. Of plain
/// pixels none is, and it is not looked whether any should be. `out` has the size of `in`, and may be the same pixels.
void scale_row(float scale, std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels, LeftPixels& left);

/// The same with scale = table(Y).
void scale_row(const LuminanceTable& table, std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels,
               LeftPixels& left);

/// The same with scale = table(adaptation[x]).
void scale_row(const LuminanceTable& table, std::span<const float> adaptation, std::span<const XYZ> in,
               std::span<XYZ> out, RowPixels pixels, LeftPixels& left);

/// The same with scale = e * compressions(e * Y), e = exposures(adaptation[x]).
void scale_row(const LuminanceTable& exposures, const LuminanceTable& compressions, std::span<const float> adaptation,
               std::span<const XYZ> in, std::span<XYZ> out, RowPixels pixels, LeftPixels& left);

}  // namespace emulsion
