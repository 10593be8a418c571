#pragma once
// Daylight of any chromaticity near the daylight locus.

#include "spectrum/rgb_space.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// S0 + M1 S1 + M2 S2, with M1 and M2 such that its CIE 1931 chromaticity is the one given; 360-830 nm, about 100 at
/// 560 nm. On the daylight locus these are the CIE's D illuminants, but for the rounding of their published M1 and M2.
/// Source of the components: Judd, MacAdam & Wyszecki, JOSA 54 (1964); CIE 15:2004, section 3.1.
/// \throws std::invalid_argument if the mixture is negative anywhere, as it is far from daylight.
[[nodiscard]] PiecewiseLinearSpectrum daylight(const Chromaticity& chromaticity);

}  // namespace emulsion
