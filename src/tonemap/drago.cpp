#include "tonemap/drago.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

/// 1 / max of 8 u / ((2 + 8 u) ln(2 + 8 u)), which is 0.373365 at u = 0.4196: how fast the logarithm of the base grows.
constexpr double kMostGrowth = 0.37337;

struct Curve {
    double most;      ///< L of the robust maximum
    double exponent;  ///< of L / most in the base
    double white;     ///< Ld of `most`

    /// Ld / L.
    [[nodiscard]] double operator()(double scaled) const noexcept {
        const double growth_of_log = most / ((1.0 + most) * std::log1p(most));
        if (scaled > most) {
            const double slope = growth_of_log - 0.8 * exponent / std::numbers::ln10;
            return white * (1.0 + slope * std::log(scaled / most)) / scaled;
        }
        const double log_over_scaled = scaled < 1e-8 ? 1.0 : std::log1p(scaled) / scaled;
        const double base = 2.0 + 8.0 * std::pow(scaled / most, exponent);
        return white * std::numbers::ln10 / std::log1p(most) * log_over_scaled / std::log(base);
    }
};

}  // namespace

Adaptation own_adaptation(const Drago&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const Drago& mapper, const SceneLuminance& luminance, double adaptation_cdm2) {
    const double bias = mapper.bias;
    const double brightness = std::pow(1.0 + bias - 0.85, 5.0);
    const double most = brightness * luminance.robust_max_cdm2() / adaptation_cdm2;
    const double growth_of_log = most / ((1.0 + most) * std::log1p(most));
    const double exponent = std::min(std::log(bias) / std::log(0.5), growth_of_log / kMostGrowth);
    return {.exposure = [=](double adaptation) { return brightness / adaptation; },
            .compression = Curve{most, exponent, mapper.peak / 100.0}};
}

}  // namespace emulsion
