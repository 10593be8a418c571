#include "tonemap/reinhard_local.h"

#include "tonemap/reinhard_global.h"

namespace emulsion {

Adaptation own_adaptation(const ReinhardLocal&) noexcept { return CentreSurroundAdaptation{}; }

ToneReproduction prepare(const ReinhardLocal& mapper, const SceneLuminance& luminance, double) {
    const double key = mapper.key > 0.0f ? double{mapper.key} : photographic_key(luminance);
    const double log_average = luminance.log_average_cdm2();
    // key / log_average / (1 + key / log_average Ya), without a quotient that may overflow.
    return {.exposure = [=](double adaptation) { return key / (log_average + key * adaptation); }};
}

}  // namespace emulsion
