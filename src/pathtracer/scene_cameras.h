#pragma once
// The Camera directive. Names, defaults and meaning are those of pbrt-v4.

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene_camera.h"
#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_warnings.h"

namespace emulsion {

/// The exposure time is shutterclose - shutteropen, or the other way round if that is less than 0, as in pbrt-v4;
/// nothing moves meanwhile.
/// \throws SceneError naming the token at fault.
[[nodiscard]] Camera read_camera(const ParameterList& list, const Imath::M44d& camera_from_world,
                                 double& exposure_time_s, SceneWarnings& warnings);

}  // namespace emulsion
