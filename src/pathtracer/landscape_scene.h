#pragma once
// A landscape of as many triangles as one likes, under a sky and a lamp: the geometry is large, all else is simple. For
// measuring what grows with triangles.

#include <cstdint>

#include "pathtracer/scene.h"

namespace emulsion {

/// Grey hills from above, a grid of at least `triangles` triangles in [1, 1e9], and less than a percent more from
/// 100,000 on; a sky and a square lamp of two triangles. `side_px` by as many pixels. All other settings are the
/// defaults but for independent samples and a box filter, so that errors are those of plain Monte Carlo. \throws
/// std::invalid_argument naming `triangles` if there are fewer or more.
[[nodiscard]] Scene landscape_scene(std::int64_t triangles, int side_px);

}  // namespace emulsion
