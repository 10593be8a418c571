#pragma once
// Line emitters: lines without width, and narrow Gaussians. The power of a line is its integral over the wavelength, in
// the unit of the continuum times nm: W m^-2 sr^-1 for a radiance.

#include <vector>

#include "spectrum/spectrum_wavelengths.h"

namespace emulsion {

/// A line without width: power times Dirac's delta(lambda - lambda_nm).
struct Line {
    double lambda_nm = 0.0;  ///< finite, > 0
    double power = 0.0;      ///< finite
    bool operator==(const Line&) const = default;
};

/// power / (sigma sqrt(2 pi)) exp(-(lambda - mean)^2 / (2 sigma^2)), with sigma = fwhm_nm / sqrt(8 ln 2); 0 further
/// than kGaussianReach sigma from the mean.
struct GaussianLine {
    double mean_nm = 0.0;  ///< finite, > 0
    double fwhm_nm = 1.0;  ///< full width at half maximum; [1e-6, inf): what is narrower is a Line
    double power = 0.0;    ///< finite
    bool operator==(const GaussianLine&) const = default;
};

/// sqrt(8 ln 2): a Gaussian's full width at half maximum over its sigma.
inline constexpr double kFwhmPerSigma = 2.3548200450309493;

/// Where a Gaussian is cut off, in sigma: at 3e-28 of its maximum, and without 3e-29 of its power.
inline constexpr double kGaussianReach = 11.25;

/// The sum of any number of lines.
struct LineSpectrum {
    std::vector<Line> line;              ///< no two at one wavelength; in any order
    std::vector<GaussianLine> gaussian;  ///< in any order
    bool operator==(const LineSpectrum&) const = default;
};

/// The Gaussians alone: a line without width has no value.
void eval(const LineSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept;

/// Wavelengths between which no Gaussian is narrow: mean and several multiples of sigma, the last where it is cut off;
/// increasing. The lines without width are not among them.
[[nodiscard]] std::vector<double> knots_nm(const LineSpectrum& spectrum);

/// \throws std::invalid_argument naming the field, its value and its range.
void validate(const LineSpectrum& spectrum);

}  // namespace emulsion
