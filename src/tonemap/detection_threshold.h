#pragma once

namespace emulsion {

/// Smallest difference from a background of `adaptation_cdm2` >= 0 that an eye adapted to it detects, in cd/m^2; by
/// rods below 0.958 cd/m^2, by cones above:
///     log10 dL = -2.86 for log10 La < -3.94, (0.405 log10 La + 1.6)^2.18 - 2.86 for < -1.44, log10 La - 0.395 for
///     < -0.0184, (0.249 log10 La + 0.65)^2.7 - 0.72 for < 1.9, log10 La - 1.255 above.
/// The printed digits leave steps of 2.7 % at 10^-1.44 and 0.8 % at 10^1.9.
/// Source: Ward Larson, Rushmeier & Piatko 1997 (histogram_adjustment.h), section on human contrast
/// sensitivity: the lower of the two curves that Ferwerda, Pattanaik, Shirley & Greenberg fit to rods and cones in "A
/// Model of Visual Adaptation for Realistic Image Synthesis", SIGGRAPH 1996.
[[nodiscard]] double detection_threshold_cdm2(double adaptation_cdm2) noexcept;

}  // namespace emulsion
