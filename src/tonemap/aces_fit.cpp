#include "tonemap/aces_fit.h"

namespace emulsion {

namespace {

/// Ld / L.
double curve_over_scaled(double scaled) noexcept {
    return (2.51 * scaled + 0.03) / (scaled * (2.43 * scaled + 0.59) + 0.14);
}

}  // namespace

Adaptation own_adaptation(const AcesFit&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const AcesFit& mapper, const SceneLuminance&, double) {
    return {.exposure = [key = double{mapper.key}](double adaptation) { return key / adaptation; },
            .compression = curve_over_scaled};
}

}  // namespace emulsion
