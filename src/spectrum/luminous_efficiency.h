#pragma once
// How much light of each wavelength counts in photometry: dimensionless, 1 at the peak.

#include "spectrum/spectrum.h"

namespace emulsion {

/// V(lambda), eyes adapted to light: 360-830 nm at 1 nm, straight lines between and 0 outside; 1 at 555 nm. The ybar of
/// the CIE 1931 observer, with which it agrees to 1e-12. Multiply by 683 lm/W (kLuminousEfficacy).
/// Source: CIE 1924; ISO 23539.
[[nodiscard]] const PiecewiseLinearSpectrum& photopic_efficiency();

/// V'(lambda), eyes adapted to the dark: 380-780 nm at 1 nm, straight lines between and 0 outside; 1 at 507 nm.
/// Multiply by 1700 lm/W. Source: CIE 1951; ISO 23539.
[[nodiscard]] const PiecewiseLinearSpectrum& scotopic_efficiency();

}  // namespace emulsion
