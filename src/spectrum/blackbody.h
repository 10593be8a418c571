#pragma once
// Planck's law, in absolute units and relative to its peak.

#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

/// Spectral radiance of a blackbody in vacuum, W m^-2 sr^-1 nm^-1; temperature_K > 0, lambda_nm > 0.
/// Source: Planck's law with the constants of the SI (2019): second radiation constant 1.438776877e-2 m K.
[[nodiscard]] double planck_radiance(double temperature_K, double lambda_nm) noexcept;

/// The same over its largest value over all wavelengths (at lambda T = 2.897771955e-3 m K, Wien); in [0, 1].
[[nodiscard]] double relative_planck_radiance(double temperature_K, double lambda_nm) noexcept;

/// What the values of a blackbody are.
enum class BlackbodyUnit {
    relative,  ///< 1 at the peak, be it visible or not
    radiance   ///< W m^-2 sr^-1 nm^-1
};

/// Planck's law as a spectrum: planck_radiance or relative_planck_radiance.
/// Source: CIE 15:2004; constants of the SI, 2019.
struct BlackbodySpectrum {
    double temperature_K = 6500.0;  ///< finite, > 0
    BlackbodyUnit unit = BlackbodyUnit::relative;
    bool operator==(const BlackbodySpectrum&) const = default;
};

/// As many values as wavelengths.
void eval(const BlackbodySpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const BlackbodySpectrum& spectrum);

}  // namespace emulsion
