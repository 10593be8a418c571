#pragma once
// What stands before WorldBegin: Camera, Film, Sampler, PixelFilter, Integrator. Names, defaults and meaning are those
// of pbrt-v4, but for two defaults: the sampler is "paddedsobol" of 16 samples, and films are stored as 32-bit floats
// unless "bool savefp16" true says otherwise. PixelFilter takes two filters more: "catmull-rom" and "blackman-harris".
// A crop window that leaves the frame is an error, not cut off, and so are "cropwindow" and "pixelbounds" together.

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_parameters.h"

namespace emulsion {

/// Each reads one directive and leaves the other fields alone.
/// The exposure time is shutterclose - shutteropen; the film's sensor gets its own at check_sensor, as camera and film
/// come in any order. "whitebalance" is a nominal temperature, as in the names of the D illuminants, and 0 means none.
/// \throws SceneError naming the token at fault.
[[nodiscard]] Camera read_camera(const ParameterList& list, const Imath::M44d& camera_from_world,
                                 double& exposure_time_s);
void read_film(const ParameterList& list, FilmSettings& film);
void read_sampler(const ParameterList& list, Sampler& sampler, int& seed);
[[nodiscard]] Filter read_filter(const ParameterList& list);

/// What only camera and film together show.
/// \throws SceneError at `place` if the product of exposure time and ISO is out of the sensor's range.
void check_sensor(const SourcePlace& place, const SensorOptions& sensor);

/// "lightsampler" is read and has no effect: how lights are picked (here: half by power, half in equal shares to all
/// lights) changes the noise, not the picture.
[[nodiscard]] PathIntegratorSettings read_integrator(const ParameterList& list);

}  // namespace emulsion
