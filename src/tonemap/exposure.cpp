#include "tonemap/exposure.h"

#include <cmath>

#include "core/middle_grey.h"

namespace emulsion {

Adaptation own_adaptation(const Exposure&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const Exposure& mapper, const SceneLuminance&, double) {
    const double metered = kMiddleGrey * std::exp2(double{mapper.ev});
    return {.exposure = [=](double adaptation) { return metered / adaptation; }};
}

}  // namespace emulsion
