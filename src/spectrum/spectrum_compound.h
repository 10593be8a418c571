#pragma once
// Products and scaled sums of spectra, of any kind and to any depth.

#include <span>
#include <vector>

#include "spectrum/spectrum_lines.h"
#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

struct Spectrum;

/// scale times every factor: a reflectance under a light, a light through a filter. Without factors, the scale. A line
/// without width times a continuum is the line, scaled; two of them at one wavelength can't be multiplied.
struct ProductSpectrum {
    std::vector<Spectrum> factor;
    double scale = 1.0;  ///< finite
    bool operator==(const ProductSpectrum&) const = default;
};

/// The sum of weight[i] term[i]: a lamp of several emitters. Without terms, 0.
struct SumSpectrum {
    std::vector<Spectrum> term;
    std::vector<double> weight;  ///< as many, finite
    bool operator==(const SumSpectrum&) const = default;
};

void eval(const ProductSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;
void eval(const SumSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;

[[nodiscard]] double limit(const ProductSpectrum& spectrum, double lambda_nm, Side side) noexcept;
[[nodiscard]] double limit(const SumSpectrum& spectrum, double lambda_nm, Side side) noexcept;

[[nodiscard]] std::vector<double> knots_nm(const ProductSpectrum& spectrum);
[[nodiscard]] std::vector<double> knots_nm(const SumSpectrum& spectrum);

[[nodiscard]] std::vector<Line> delta_lines(const ProductSpectrum& spectrum);
[[nodiscard]] std::vector<Line> delta_lines(const SumSpectrum& spectrum);

/// Of the product of the factors, by increasing wavelength.
/// \throws std::invalid_argument for lines without width at one wavelength in two factors.
[[nodiscard]] std::vector<Line> delta_lines_of_product(std::span<const Spectrum* const> factors);

/// \throws std::invalid_argument naming the field, its value and its range; as the parts do; for two lines without
/// width at one wavelength in different factors.
void validate(const ProductSpectrum& spectrum);
void validate(const SumSpectrum& spectrum);

}  // namespace emulsion
