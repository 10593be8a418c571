#pragma once
// White balance: the light that a picture was lit by is to come out neutral. XYZ in and out are the sensor's, absolute;
// the luminance of the light itself is kept.

#include <variant>

#include "core/matrix3.h"
#include "spectrum/chromatic_adaptation.h"
#include "spectrum/chromaticity.h"
#include "spectrum/observer.h"

namespace emulsion {

/// The white of the stages behind the film, to which a balanced light is brought: D65 as RGB spaces have it.
inline constexpr Chromaticity kWorkingWhite = {0.3127, 0.3290};

/// A light by its correlated colour temperature: the CIE's daylight from 4000 K up (kMinDaylight_K), a blackbody below,
/// as in pbrt-v4. The two don't meet: at 4000 K they are 0.0073 apart in x, y.
/// pbrt-v4 takes nominal temperatures: see daylight_temperature_of_nominal.
struct TemperatureWhite {
    double temperature_K = 6500.0;  ///< in [1000, 25000]
    bool operator==(const TemperatureWhite&) const = default;
};

/// Off where there is none: then nothing is adapted, and XYZ are those of the light that came in.
struct WhiteBalance {
    /// The light. A temperature means that light as the sensor sees it, with whatever observer or camera it has, so
    /// that it comes out neutral exactly; a chromaticity is of the sensor's own XYZ.
    std::variant<TemperatureWhite, Chromaticity> white;
    ChromaticAdaptation method = BradfordAdaptation{};  ///< Bradford is pbrt-v4's
    bool operator==(const WhiteBalance&) const = default;
};

/// \throws std::invalid_argument for a temperature out of its range and a chromaticity that the method can't adapt
/// from, naming field, value and range.
void validate(const WhiteBalance& balance);

/// From the XYZ of a sensor that responds as `sensor` to XYZ with the light at kWorkingWhite.
/// Source: Pharr, Jakob & Humphreys, "Physically Based Rendering", 4th ed., section 5.4.2, `WhiteBalance`. Departs from
/// it for cameras, whose light pbrt-v4 has the least squares bring to white: that is CameraTraining's
/// target_illuminant. \throws std::invalid_argument as validate() does, and if the sensor sees nothing of the light.
[[nodiscard]] Matrix3 white_balance_matrix(const WhiteBalance& balance, const Observer& sensor);

}  // namespace emulsion
