#pragma once
// Objects and instances brought into the form that is traced.

#include <cstddef>
#include <vector>

#include "pathtracer/scene.h"

namespace emulsion {

/// Shapes of a scene from `first` up to `end`.
struct ShapeRange {
    std::size_t first = 0, end = 0;
};

/// Moves the shapes of the scene's objects behind the scene's own, so that every shape has one number, and returns
/// where those of each object are: instances then count these. Objects without an instance are gone. Those with one
/// alone are shapes of the scene, mapped to where it stands: rays then need not be mapped, and one hierarchy holds all.
/// Area lights in objects are gone: they do not shine in pbrt-v4, either.
[[nodiscard]] std::vector<ShapeRange> settle_objects(Scene& scene);

}  // namespace emulsion
