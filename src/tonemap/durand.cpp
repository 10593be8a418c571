#include "tonemap/durand.h"

#include <algorithm>
#include <cmath>

namespace emulsion {

Adaptation own_adaptation(const Durand&) noexcept { return BilateralAdaptation{}; }

ToneReproduction prepare(const Durand& mapper, const SceneLuminance& luminance, double) {
    const double most = luminance.robust_max_cdm2();
    const double range = std::log(most / luminance.robust_min_cdm2());
    const double exponent = range > 0.0 ? std::min(std::log(double{mapper.contrast}) / range, 1.0) : 1.0;
    return {.exposure = [=](double adaptation) { return std::pow(adaptation / most, exponent) / adaptation; }};
}

}  // namespace emulsion
