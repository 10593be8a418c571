#pragma once
// What stands before WorldBegin: Camera, Film, Sampler, PixelFilter, Integrator. Names, defaults and meaning are those
// of pbrt-v4, but for two defaults: the sampler is "paddedsobol" of 16 samples, and films are stored as 32-bit floats
// unless "bool savefp16" true says otherwise. PixelFilter takes two filters more: "catmull-rom" and "blackman-harris".

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_parameters.h"

namespace emulsion {

/// What the imaging ratio is made of; Camera and Film give one each, in any order.
struct Exposure {
    double time_s = 1.0;  ///< shutterclose - shutteropen; > 0
    double iso = 100.0;   ///< > 0

    [[nodiscard]] double imaging_ratio() const noexcept { return time_s * iso / 100.0; }
};

/// Each reads one directive and leaves the other fields alone.
/// \throws SceneError naming the token at fault.
void read_camera(const ParameterList& list, const Imath::M44d& camera_from_world, PerspectiveCamera& camera,
                 Exposure& exposure);
void read_film(const ParameterList& list, FilmSettings& film, Exposure& exposure);
void read_sampler(const ParameterList& list, Sampler& sampler, int& seed);
[[nodiscard]] Filter read_filter(const ParameterList& list);

/// "lightsampler" is read and has no effect: how lights are picked (here: half by power, half in equal shares to all
/// lights) changes the noise, not the picture.
[[nodiscard]] PathIntegratorSettings read_integrator(const ParameterList& list);

}  // namespace emulsion
