#pragma once
// The inner loop of the conversion to display RGB: one row of pixels.

#include <array>
#include <span>

#include "core/color.h"

namespace emulsion {

/// rgb = matrix xyz - pedestal, in single precision; as many of one as of the other. Rows of the matrix in turn.
void linear_rgb(const std::array<float, 9>& matrix, float pedestal, std::span<const XYZ> xyz,
                std::span<RGB> rgb) noexcept;

}  // namespace emulsion
