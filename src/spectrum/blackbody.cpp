#include "spectrum/blackbody.h"

#include <cmath>
#include <cstddef>

#include "core/units.h"
#include "spectrum/spectrum_checks.h"

namespace emulsion {

namespace {

constexpr double kSecondRadiation_nmK = 1e9 * kSecondRadiation_mK;

// h c / (lambda k T) where lambda^-5 / (exp(x) - 1) is largest: the root of x = 5 (1 - exp(-x)) (Wien).
constexpr double kPeakExponent = 4.965114231744276;

double fifth_power(double x) noexcept { return x * x * (x * x) * x; }

/// h c / (lambda k T); lambda T alone may overflow.
double planck_exponent(double temperature_K, double lambda_nm) noexcept {
    return kSecondRadiation_nmK / lambda_nm / temperature_K;
}

}  // namespace

double planck_radiance(double temperature_K, double lambda_nm) noexcept {
    const double lambda_m = 1e-9 * lambda_nm;
    const double per_nm = 1e-9 * 2.0 * kPlanck * kSpeedOfLight * kSpeedOfLight / fifth_power(lambda_m);
    return per_nm / std::expm1(planck_exponent(temperature_K, lambda_nm));
}

double relative_planck_radiance(double temperature_K, double lambda_nm) noexcept {
    const double exponent = planck_exponent(temperature_K, lambda_nm);
    // (lambda_peak / lambda)^5 written by the exponents; exp(x) may overflow to infinity, and the quotient to 0 is
    // right.
    if (exponent > 700.0) return 0.0;
    return fifth_power(exponent / kPeakExponent) * std::expm1(kPeakExponent) / std::expm1(exponent);
}

void eval(const BlackbodySpectrum& spectrum, const OffsetWavelengths& at, std::span<double> values) noexcept {
    const double temperature_K = spectrum.temperature_K;
    const bool is_relative = spectrum.unit == BlackbodyUnit::relative;
    for (std::size_t i = 0; i < at.size(); ++i) {
        values[i] =
            is_relative ? relative_planck_radiance(temperature_K, at[i]) : planck_radiance(temperature_K, at[i]);
    }
}

void validate(const BlackbodySpectrum& spectrum) {
    require_positive("blackbody: temperature_K", spectrum.temperature_K);
}

}  // namespace emulsion
