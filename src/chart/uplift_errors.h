#pragma once
// How well uplifts of RGB keep colours: those that they are asked for, and those of measured reflectances when the
// light changes. In CIEDE2000, one number a colour.

#include <functional>
#include <string_view>
#include <vector>

#include "spectrum/rgb_space.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {

/// Visits levels^3 colours, evenly spaced in encoded sRGB and so nearly even to the eye. Linear; levels >= 2.
void for_each_colour(int levels, const std::function<void(const RGBd&)>& visit);

/// Between colours and those that come back under the space's white. Of other spaces than sRGB the same levels are
/// taken.
[[nodiscard]] std::vector<double> round_trips(const RgbUplift& uplift, const RgbSpace& space, int levels);

/// 24 of the ColorChecker and 24 of AMPAS.
[[nodiscard]] std::vector<Spectrum> measured_reflectances();

/// Between measured reflectances and uplifts of their colours, under an illuminant of the table illuminants_5nm. Only
/// of those whose colours are within [0, 1]. \throws std::invalid_argument for an unknown one.
[[nodiscard]] std::vector<double> drifts(const RgbUplift& uplift, std::string_view illuminant);

}  // namespace emulsion
