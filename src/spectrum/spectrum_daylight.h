#pragma once
// The CIE's daylight of a given correlated colour temperature.

#include <array>
#include <vector>

#include "spectrum/chromaticity.h"
#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

/// The range of the daylight locus, K.
inline constexpr double kMinDaylight_K = 4000.0, kMaxDaylight_K = 25000.0;

/// How the weights M1 and M2 of the daylight components are taken.
enum class DaylightWeights {
    three_decimals,  ///< rounded to 0.001: with these the published tables of the D illuminants were made
    exact
};

/// S0 + M1 S1 + M2 S2, with M1 and M2 by colour temperature: relative power, about 100 at 560 nm. Straight lines
/// between the components' values, 300-830 nm every 5 nm, and 0 outside. D65 is 6504 K, not 6500 K: see
/// daylight_temperature_of_nominal().
/// Source: CIE 15:2004, section 3.1, with the components of Judd, MacAdam & Wyszecki, JOSA 54 (1964).
struct DaylightSpectrum {
    double temperature_K = 6504.0;  ///< correlated colour temperature; [4000, 25000]
    DaylightWeights weights = DaylightWeights::three_decimals;
    bool operator==(const DaylightSpectrum&) const = default;
};

/// The colour temperature that a nominal one stands for: the D illuminants are named for 5000, 5500, 6500 and 7500 K
/// on the temperature scale of their time, with c2 = 1.4380e-2 m K. With 1.4388e-2 m K, which the formulas of CIE
/// 15:2004 go by, these are 5002.8, 5503.1, 6503.6 and 7504.2 K; the standard takes whole kelvins, 5003, 5503, 6504 and
/// 7504. This function doesn't round.
[[nodiscard]] double daylight_temperature_of_nominal(double nominal_K) noexcept;

/// The point of the daylight locus, for a temperature in [4000, 25000] K.
/// Source: CIE 15:2004, section 3.1, eq. 3.2-3.4: cubics in 1/T below and above 7000 K (which meet to 3e-7), and a
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
