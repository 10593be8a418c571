#pragma once
// LightSource and AreaLightSource. All light spectra are normalised as pbrt-v4 does: `scale` is luminance in cd/m^2 (an
// L of area and infinite lights), intensity in cd (I of point and spot lights), illuminance in lux (L of distant
// lights), for a spectrum as such or an RGB light that is white. `power` in lumen and `illuminance` in lux multiply
// with it, if they are above 0: else they are as good as not there.

#include <optional>
#include <span>

#include <Imath/ImathMatrix.h>

#include "pathtracer/scene.h"
#include "pathtracer/scene_files.h"
#include "pathtracer/scene_parameters.h"
#include "pathtracer/scene_spectra.h"
#include "pathtracer/scene_warnings.h"

namespace emulsion {

/// What a LightSource directive stands in: the current transformation, what reads its spectra and files, and where
/// warnings go.
struct LightContext {
    Imath::M44d world_from_object;
    SpectrumReader& spectra;
    SceneFiles& files;
    SceneWarnings& warnings;
};

/// \throws SceneError for parameters that make no light, and for a picture that can't be read.
[[nodiscard]] Light read_light(const ParameterList& list, const LightContext& context);

/// \throws SceneError if the light is too bright, at some wavelength, for the renderer's single precision.
void check_brightness(const ScaledSpectrum& light, const SourcePlace& place);

/// What an AreaLightSource says about the shapes that follow it.
struct AreaLightSource {
    ScaledSpectrum radiance;         ///< W m^-2 sr^-1 nm^-1
    std::optional<double> power_lm;  ///< of each light; `radiance` is then per lm/(m^2 sr) of it
    bool two_sided = false;
    SourcePlace place;
};

[[nodiscard]] AreaLightSource read_area_light(const ParameterList& list, SpectrumReader& spectra);

/// The light of one shape. A given power is spread over each of its `light_areas`, on both sides if two-sided: see
/// light_areas() for what pbrt-v4 takes for one light.
/// \throws SceneError if the radiance overflows.
[[nodiscard]] AreaLight light_of_shape(const AreaLightSource& source, std::span<const double> light_areas);

}  // namespace emulsion
