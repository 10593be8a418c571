#include "tonemap/tumblin_rushmeier.h"

#include <algorithm>
#include <cmath>

namespace emulsion {

double stevens_exponent(double adaptation_cdm2) noexcept {
    return std::clamp(1.855 + 0.4 * std::log10(adaptation_cdm2 + 2.3e-5), 0.0, 2.655);
}

Adaptation own_adaptation(const TumblinRushmeier&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const TumblinRushmeier& mapper, const SceneLuminance& luminance, double adaptation_cdm2) {
    // Lda / peak is 1 / sqrt(contrast).
    const double root = std::sqrt(double{mapper.contrast});
    const double exponent = stevens_exponent(adaptation_cdm2) / stevens_exponent(mapper.peak / root);
    const double grey = std::pow(root, exponent - 1.0) / root;
    const double least = 1e-3 * luminance.robust_min_cdm2() / adaptation_cdm2;
    return {
        .exposure = [](double adaptation) { return 1.0 / adaptation; },
        .compression = [=](double relative) { return grey * std::pow(std::hypot(relative, least), exponent - 1.0); }};
}

}  // namespace emulsion
