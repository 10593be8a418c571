#pragma once
// Spectra that are straight lines between samples, at irregular or at equidistant wavelengths.

#include <vector>

#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

/// What a table is outside its wavelengths.
enum class Extrapolation {
    zero,     ///< 0, with a jump at both ends (as pbrt-v4 takes the "spectrum" parameters of a scene)
    hold,     ///< the value at the nearest end
    straight  ///< the straight line of the first or last two samples goes on, below 0 too
};

/// Straight lines between knots.
struct PiecewiseLinearSpectrum {
    std::vector<double> lambda_nm;  ///< at least one, two to go on straight; finite, strictly increasing
    std::vector<double> value;      ///< as many, finite
    Extrapolation extrapolation = Extrapolation::zero;
    bool operator==(const PiecewiseLinearSpectrum&) const = default;
};

/// Straight lines between samples at first_nm, first_nm + step_nm, ...: as the one above, found without a search.
struct DenseSpectrum {
    double first_nm = 0.0;      ///< finite
    double step_nm = 1.0;       ///< finite, > 0, and large enough to set the wavelengths apart
    std::vector<double> value;  ///< at least one, two to go on straight; finite
    Extrapolation extrapolation = Extrapolation::zero;
    bool operator==(const DenseSpectrum&) const = default;

    [[nodiscard]] double lambda_nm(std::size_t i) const noexcept { return first_nm + static_cast<double>(i) * step_nm; }
    [[nodiscard]] double last_nm() const noexcept { return value.empty() ? first_nm : lambda_nm(value.size() - 1); }
};

/// As many values as wavelengths. Piecewise linear: neighbours in increasing order are found by walking the knots.
void eval(const PiecewiseLinearSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;
void eval(const DenseSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;

[[nodiscard]] double limit(const PiecewiseLinearSpectrum& spectrum, double lambda_nm, Side side) noexcept;
[[nodiscard]] double limit(const DenseSpectrum& spectrum, double lambda_nm, Side side) noexcept;

[[nodiscard]] std::vector<double> knots_nm(const PiecewiseLinearSpectrum& spectrum);
[[nodiscard]] std::vector<double> knots_nm(const DenseSpectrum& spectrum);

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const PiecewiseLinearSpectrum& spectrum);
void validate(const DenseSpectrum& spectrum);

}  // namespace emulsion
