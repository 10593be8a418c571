#pragma once
// How brightly the lights of a scene shine, for picking among them.

#include <cstddef>
#include <vector>

#include "pathtracer/scene_light.h"

namespace emulsion {

/// Photometric strength of a light's spectrum: lm/683 in whatever it is per.
[[nodiscard]] double photometric_strength(const ScaledSpectrum& spectrum);

/// What a spot light shines into: its flux over its intensity along the axis, sr. The cosines are those of SpotLight.
[[nodiscard]] double spot_solid_angle(double cos_full, double cos_none) noexcept;

/// The luminous fluxes by which emitters are picked.
struct LightPowers {
    std::vector<double> emitter;         ///< of each, in lm/683
    std::vector<std::size_t> light_end;  ///< one past the last emitter of each light: a shape has one for each triangle

    /// Half by flux and half in equal shares to all lights, so that none is starved whose flux says little about how it
    /// lights what is seen: a small lamp in a large landscape under the sun. Positive sum, unless there are no lights.
    [[nodiscard]] std::vector<double> weights() const;
};

}  // namespace emulsion
