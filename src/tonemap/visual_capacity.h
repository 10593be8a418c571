#pragma once
// How many just noticeable differences lie below a luminance.

namespace emulsion {

/// C(Y) = integral of dY / TVI(Y) from 0 to Y, in just noticeable differences: Y / 0.0014 below 10^-2.465 cd/m^2,
/// 2.483133 + ln(Y / 10^-2.465) / 0.4027 up to 1, 16.577079 + (Y - 1) / 0.4027 up to 10^0.86, then
/// 32.082655 + ln(Y / 10^0.86) / 0.0556, all constants unrounded. Continuous, rising. `luminance_cdm2` >= 0.
/// log10 TVI = -2.86; log10 Y - 0.395; -0.395; log10 Y - 1.255 in the four intervals.
/// Source: Ashikhmin, "A Tone Mapping Algorithm for High Contrast Images", Eurographics Workshop on Rendering 2002,
/// eq. 2 and 3, natural logarithms.
[[nodiscard]] double visual_capacity(double luminance_cdm2) noexcept;

/// The same with the constants as printed: breaks 0.0034, 1, 7.2444; offsets 2.4483, 16.563, 32.0693. For comparison;
/// it jumps by up to 0.02 at the breaks.
[[nodiscard]] double printed_visual_capacity(double luminance_cdm2) noexcept;

}  // namespace emulsion
