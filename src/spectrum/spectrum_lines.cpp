#include "spectrum/spectrum_lines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include <fmt/core.h>

#include "spectrum/spectrum_checks.h"

namespace emulsion {

namespace {

constexpr double kMinFwhm_nm = 1e-6;
constexpr double kRootTwoPi = 2.5066282746310005;

}  // namespace

void eval(const LineSpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    std::fill(values.begin(), values.end(), 0.0);
    for (const GaussianLine& gaussian : spectrum.gaussian) {
        const double sigma_nm = gaussian.fwhm_nm / kFwhmPerSigma;
        const double peak = gaussian.power / (sigma_nm * kRootTwoPi);
        const double base_nm = at.base_nm - gaussian.mean_nm;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double t = (base_nm + at.offset_nm[i]) / sigma_nm;
            if (std::abs(t) <= kGaussianReach) values[i] += peak * std::exp(-0.5 * t * t);
        }
    }
}

std::vector<double> knots_nm(const LineSpectrum& spectrum) {
    std::vector<double> knots;
    for (const GaussianLine& gaussian : spectrum.gaussian) {
        for (const double sigmas :
             {-kGaussianReach, -8.0, -6.0, -4.5, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.5, 6.0, 8.0, kGaussianReach}) {
            knots.push_back(gaussian.mean_nm + sigmas * gaussian.fwhm_nm / kFwhmPerSigma);
        }
    }
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
}

void validate(const LineSpectrum& spectrum) {
    std::vector<double> wavelengths_nm;
    for (std::size_t i = 0; i < spectrum.line.size(); ++i) {
        require_positive(fmt::format("line spectrum: line[{}].lambda_nm", i), spectrum.line[i].lambda_nm);
        require_finite(fmt::format("line spectrum: line[{}].power", i), spectrum.line[i].power);
        wavelengths_nm.push_back(spectrum.line[i].lambda_nm);
    }
    std::sort(wavelengths_nm.begin(), wavelengths_nm.end());
    const auto twice = std::adjacent_find(wavelengths_nm.begin(), wavelengths_nm.end());
    if (twice != wavelengths_nm.end()) {
        throw_bad_spectrum("line spectrum: two lines at lambda_nm", *twice, "one line, with the sum of their powers");
    }
    for (std::size_t i = 0; i < spectrum.gaussian.size(); ++i) {
        const GaussianLine& gaussian = spectrum.gaussian[i];
        const std::string name = fmt::format("line spectrum: gaussian[{}]", i);
        require_positive(name + ".mean_nm", gaussian.mean_nm);
        require_finite(name + ".power", gaussian.power);
        if (!std::isfinite(gaussian.fwhm_nm) || gaussian.fwhm_nm < kMinFwhm_nm) {
            throw_bad_spectrum(name + ".fwhm_nm", gaussian.fwhm_nm, "a finite number >= 1e-6, or a line without width");
        }
    }
}

}  // namespace emulsion
