#pragma once
// Physical constants, SI units unless the name says otherwise.

namespace emulsion {

/// Luminous efficacy of 540 THz radiation, lm/W. Exact by the definition of the candela (SI brochure, 9th ed., 2019).
inline constexpr double kLuminousEfficacy = 683.0;

/// The same for scotopic vision, lm/W, rounded as it is commonly used. By the definition of the candela it is
/// 683 / V'(555.016 nm), at the wavelength of 540 THz in air: 1700.06 by the CIE's table of V', 4e-5 more.
inline constexpr double kScotopicLuminousEfficacy = 1700.0;

inline constexpr double kPlanck = 6.62607015e-34;     ///< J s, exact
inline constexpr double kSpeedOfLight = 299792458.0;  ///< m/s, exact
inline constexpr double kBoltzmann = 1.380649e-23;    ///< J/K, exact

/// Second radiation constant h c / k, m K: 1.438776877e-2.
inline constexpr double kSecondRadiation_mK = kPlanck * kSpeedOfLight / kBoltzmann;
/// What it was taken for when the CIE's daylight got its nominal temperatures (1.4380e-2), and in the temperature scale
/// of 1968, which CIE 15:2004 goes by (1.4388e-2).
inline constexpr double kSecondRadiationDaylight_mK = 1.4380e-2;
inline constexpr double kSecondRadiation1968_mK = 1.4388e-2;

/// The wavelengths that rendering covers: the range of the CIE 1931 colour-matching functions, nm.
inline constexpr int kMinWavelength_nm = 360;
inline constexpr int kMaxWavelength_nm = 830;

}  // namespace emulsion
