#include "tonemap/local_adaptation.h"

#include "tonemap/contrast.h"

namespace emulsion {

Adaptation own_adaptation(const LocalAdaptation&) noexcept { return UniformRadiusAdaptation{}; }

ToneReproduction prepare(const LocalAdaptation& mapper, const SceneLuminance& luminance, double adaptation_cdm2) {
    return prepare(ContrastScale{mapper.peak}, luminance, adaptation_cdm2);
}

}  // namespace emulsion
