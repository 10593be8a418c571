#include "tonemap/max_to_white.h"

namespace emulsion {

Adaptation own_adaptation(const MaxToWhite&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const MaxToWhite&, const SceneLuminance& luminance, double) {
    return {.exposure = [scale = 1.0 / luminance.statistics().max_cdm2](double) { return scale; }};
}

}  // namespace emulsion
