#pragma once
// The CIE's daylight of a given correlated colour temperature.

#include <array>
#include <vector>

#include "core/units.h"
#include "spectrum/chromaticity.h"
#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

/// The range of the daylight locus, K.
inline constexpr double kMinDaylight_K = 4000.0, kMaxDaylight_K = 25000.0;

/// The colour temperature that a nominal one stands for. The D illuminants are named for 5000, 5500, 6500 and 7500 K on
/// a temperature scale with c2 = 1.4380e-2 m K; with the 1.4388e-2 m K of CIE 15:2004 these are 5002.8, 5503.1, 6503.6
/// and 7504.2 K. They are usually given as 5003, 5503, 6504 and 7504 K, but the published tables are of the unrounded
/// ones: of 6504 K, M1 is -0.294 in place of -0.295, and D65 off by 0.05 of 100.
[[nodiscard]] constexpr double daylight_temperature_of_nominal(double nominal_K) noexcept {
    return nominal_K * (kSecondRadiation1968_mK / kSecondRadiationDaylight_mK);
}

/// How the weights M1 and M2 of the daylight components are taken.
enum class DaylightWeights {
    three_decimals,  ///< rounded to 0.001: with these the published tables of the D illuminants were made
    exact
};

/// S0 + M1 S1 + M2 S2, with M1 and M2 by colour temperature: relative power, about 100 at 560 nm. Straight lines
/// between the components' values, 300-830 nm every 5 nm, and 0 outside. With the weights of three decimals, this gives
/// the tables of D50, D55, D65 and D75 to 0.001; exact ones follow the locus without steps, and differ by up to 0.02.
/// Source: CIE 15:2004, section 3.1, with the components of Judd, MacAdam & Wyszecki, JOSA 54 (1964).
struct DaylightSpectrum {
    double temperature_K = daylight_temperature_of_nominal(6500.0);  ///< correlated colour temperature; [4000, 25000]
    DaylightWeights weights = DaylightWeights::three_decimals;
    bool operator==(const DaylightSpectrum&) const = default;
};

/// The point of the daylight locus, for a temperature in [4000, 25000] K.
/// Source: CIE 15:2004, section 3.1, eq. 3.2-3.4: cubics in 1/T below and above 7000 K (which meet to 5e-7), and a
/// parabola for y.
/// \throws std::invalid_argument for a temperature out of range.
[[nodiscard]] Chromaticity daylight_chromaticity(double temperature_K);

/// M1 and M2 of the components that have a chromaticity on the daylight locus, not rounded.
/// Source: CIE 15:2004, section 3.1, eq. 3.6, whose coefficients are rounded: M1 and M2 have three good decimals.
[[nodiscard]] std::array<double, 2> daylight_weights(const Chromaticity& chromaticity) noexcept;

/// As many values as wavelengths.
void eval(const DaylightSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;

[[nodiscard]] double limit(const DaylightSpectrum& spectrum, double lambda_nm, Side side) noexcept;
[[nodiscard]] std::vector<double> knots_nm(const DaylightSpectrum& spectrum);

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const DaylightSpectrum& spectrum);

}  // namespace emulsion
