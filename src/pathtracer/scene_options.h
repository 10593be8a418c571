#pragma once
// What stands before WorldBegin, beside Camera: Film, Sampler, PixelFilter, Integrator. Names, defaults and meaning are
// those of pbrt-v4, but for three defaults: the sampler is "paddedsobol" of 16 samples, the integrator "path", which
// give the picture that pbrt-v4's "zsobol" and "volpath" do, and films are stored as 32-bit floats unless "bool
// savefp16" true says otherwise. Other samplers and integrators of the same picture are taken as these. PixelFilter
// takes two filters more: "catmull-rom" and "blackman-harris". The sensor is "cie1931": pbrt-v4's digital cameras are
// refused, as there are no curves of them here.

#include <optional>
#include <string>

#include "pathtracer/scene.h"
#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_warnings.h"

namespace emulsion {

/// Reads one directive. The film's sensor gets its exposure time later, as camera and film come in any order.
/// "whitebalance" is a nominal temperature, as in the names of the D illuminants, and 0 means none.
/// \throws SceneError naming the token at fault, as all of these do.
void read_film(const ParameterList& list, FilmSettings& film, SceneWarnings& warnings);

struct ReadSampler {
    Sampler sampler;
    std::optional<int> seed;  ///< if the directive gives one
    std::string warning;      ///< of what is taken otherwise than written; empty: nothing
};
[[nodiscard]] ReadSampler read_sampler(const ParameterList& list);

[[nodiscard]] Filter read_filter(const ParameterList& list);

/// What only camera and film together show.
/// \throws SceneError at `place` if the product of exposure time and ISO is out of the sensor's range.
void check_sensor(const SourcePlace& place, const SensorOptions& sensor);

/// The value, of an exposure, if products and quotients of a few such numbers stay finite and above 0.
/// \throws SceneError if not: found `what` and the value.
[[nodiscard]] double checked_exposure(const SourcePlace& place, double value, std::string_view what,
                                      std::string_view expected);

struct ReadIntegrator {
    PathIntegratorSettings settings;
    std::string warning;  ///< as of a sampler
};
/// "lightsampler" is read and has no effect: how lights are picked (here: half by power, half in equal shares to all
/// lights) changes the noise, not the picture.
[[nodiscard]] ReadIntegrator read_integrator(const ParameterList& list);

}  // namespace emulsion
