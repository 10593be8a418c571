#pragma once
// Planck's law, in absolute units and relative to its peak.

namespace emulsion {

/// Spectral radiance of a blackbody in vacuum, W m^-2 sr^-1 nm^-1; temperature_K > 0, lambda_nm > 0.
/// Source: Planck's law with the constants of the SI (2019): second radiation constant 1.438776877e-2 m K.
[[nodiscard]] double planck_radiance(double temperature_K, double lambda_nm) noexcept;

/// The same over its largest value over all wavelengths (at lambda T = 2.897771955e-3 m K, Wien); in [0, 1].
[[nodiscard]] double relative_planck_radiance(double temperature_K, double lambda_nm) noexcept;

}  // namespace emulsion
