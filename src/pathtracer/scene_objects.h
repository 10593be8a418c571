#pragma once
// Objects and instances brought into the form that is traced.

#include "pathtracer/scene.h"

namespace emulsion {

/// The scene as it is traced. Objects without an instance are gone. Those with one alone are shapes of the scene, mapped
/// to where it stands: rays then need not be mapped, and one hierarchy holds all. Area lights in objects are gone: they
/// do not shine in pbrt-v4, either.
[[nodiscard]] Scene with_settled_objects(Scene scene);

}  // namespace emulsion
