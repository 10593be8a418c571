#pragma once
// A scene of as many triangles as one likes.

#include <cstdint>

#include "pathtracer/scene.h"

namespace emulsion {

/// Grey hills of about `triangles` triangles under a sky and a square lamp; all other settings are the defaults but for
/// independent samples and a box filter, so that errors are those of plain Monte Carlo. `side_px` by as many pixels.
[[nodiscard]] Scene scaling_scene(std::int64_t triangles, int side_px);

}  // namespace emulsion
