#pragma once
// Physical constants, SI units unless the name says otherwise.

namespace emulsion {

/// Luminous efficacy of 540 THz radiation, lm/W. Exact by the definition of the candela (SI brochure, 9th ed., 2019).
inline constexpr double kLuminousEfficacy = 683.0;

inline constexpr double kPlanck = 6.62607015e-34;     ///< J s, exact
inline constexpr double kSpeedOfLight = 299792458.0;  ///< m/s, exact
inline constexpr double kBoltzmann = 1.380649e-23;    ///< J/K, exact

/// The wavelengths that rendering covers: the range of the CIE 1931 colour-matching functions, nm.
inline constexpr int kMinWavelength_nm = 360;
inline constexpr int kMaxWavelength_nm = 830;

}  // namespace emulsion
