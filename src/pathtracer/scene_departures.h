#pragma once
// Where pbrt-v4 would show something that we take for an error of its own, and a scene's author should know.

#include <string>

#include "pathtracer/scene_geometry.h"
#include "pathtracer/scene_material.h"

namespace emulsion {

/// Of a shape that shines: what pbrt-v4's pictures of it are, or empty if they are ours.
[[nodiscard]] std::string departure_of_light(const Geometry& geometry);

/// Of a material.
[[nodiscard]] std::string departure_of(const Material& material);

}  // namespace emulsion
