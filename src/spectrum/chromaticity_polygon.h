#pragma once
// Convex regions of the chromaticity diagram: the triangle of an RGB space, all real colours. Points and distances are
// in x, y, which says where a colour lies but little about how different it looks.

#include <span>
#include <vector>

#include "spectrum/chromaticity.h"

namespace emulsion {

/// The corners of the convex hull, counter-clockwise, without those that lie on a straight line between two others.
/// Fewer than three for points on one line.
/// Source: Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions", IPL 9 (1979).
[[nodiscard]] std::vector<Chromaticity> convex_hull(std::span<const Chromaticity> points);

/// Distance in x, y from the boundary of a convex polygon with at least three corners, counter-clockwise: positive
/// inside, negative outside. NaN for a point that is not finite.
[[nodiscard]] double signed_distance(std::span<const Chromaticity> counter_clockwise,
                                     const Chromaticity& point) noexcept;

}  // namespace emulsion
