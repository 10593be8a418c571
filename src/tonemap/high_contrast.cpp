#include "tonemap/high_contrast.h"

#include <algorithm>

#include "tonemap/visual_capacity.h"

namespace emulsion {

Adaptation own_adaptation(const HighContrast&) noexcept { return VaryingRadiusAdaptation{}; }

ToneReproduction prepare(const HighContrast&, const SceneLuminance& luminance, double) {
    const double least = visual_capacity(luminance.robust_min_cdm2());
    const double most = visual_capacity(luminance.robust_max_cdm2());
    if (!(most > least)) return {.exposure = [](double adaptation) { return 0.5 / adaptation; }};
    return {.exposure = [=](double adaptation) {
        return std::clamp((visual_capacity(adaptation) - least) / (most - least), 0.0, 1.0) / adaptation;
    }};
}

}  // namespace emulsion
