#pragma once
// The inner loops of gamut mapping: what is outside in a row of pixels, and clipping it.

#include <span>

#include "core/color.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Clips every component to [0, 1], NaN and -0 to 0 but that pixels whose components all are in [0, 1] may keep a -0.
GamutCounts clip_row(std::span<RGB> linear) noexcept;

/// Only looks. \param excess gets of each pixel the largest distance of a component from [0, 1], 0 inside; NaN counts
/// for nothing there. As many as pixels.
[[nodiscard]] GamutCounts measure_row(std::span<const RGB> linear, std::span<float> excess) noexcept;

}  // namespace emulsion
