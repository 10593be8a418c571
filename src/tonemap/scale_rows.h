#pragma once
// The inner loops of the pointwise fast path: rows of pixels times a scale each, in vectors as wide as the processor
// has. The same bits for every width.

#include <cstddef>
#include <functional>
#include <span>

#include "core/color.h"
#include "tonemap/luminance_table.h"

namespace emulsion {

/// What a pixel becomes that is bad, or for which single precision does not reach: see scale_pixels().
using ExactPixel = std::function<XYZ(std::size_t x, const XYZ& pixel)>;

/// out[x] = scale * in[x] where Y >= 0 and no component of the product is past 2^100, and exact(x, in[x]) where not.
/// `out` has the size of `in`, and may be the same pixels.
void scale_row(float scale, std::span<const XYZ> in, std::span<XYZ> out, const ExactPixel& exact);

/// The same with scale = table(Y).
void scale_row(const LuminanceTable& table, std::span<const XYZ> in, std::span<XYZ> out, const ExactPixel& exact);

/// The same with scale = table(adaptation[x]).
void scale_row(const LuminanceTable& table, std::span<const float> adaptation, std::span<const XYZ> in,
               std::span<XYZ> out, const ExactPixel& exact);

/// The same with scale = e * compressions(e * Y), e = exposures(adaptation[x]).
void scale_row(const LuminanceTable& exposures, const LuminanceTable& compressions, std::span<const float> adaptation,
               std::span<const XYZ> in, std::span<XYZ> out, const ExactPixel& exact);

}  // namespace emulsion
