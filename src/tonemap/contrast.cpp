#include "tonemap/contrast.h"

#include <cmath>

namespace emulsion {

double just_noticeable_difference_cdm2(double adaptation_cdm2) noexcept {
    return 0.0594 * std::pow(1.219 + std::pow(adaptation_cdm2, 0.4), 2.5);
}

Adaptation own_adaptation(const ContrastScale&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const ContrastScale& mapper, const SceneLuminance&, double) {
    const double peak = mapper.peak;
    const double displayed = just_noticeable_difference_cdm2(0.5 * peak);
    return {
        .exposure = [=](double adaptation) { return displayed / just_noticeable_difference_cdm2(adaptation) / peak; }};
}

}  // namespace emulsion
