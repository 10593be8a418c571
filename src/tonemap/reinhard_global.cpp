#include "tonemap/reinhard_global.h"

#include <cmath>

#include "tonemap/middle_grey.h"

namespace emulsion {

double photographic_key(const SceneLuminance& luminance) {
    const double average = std::log2(luminance.log_average_cdm2());
    const double least = std::log2(luminance.robust_min_cdm2()), most = std::log2(luminance.robust_max_cdm2());
    if (!(most > least)) return kMiddleGrey;
    return kMiddleGrey * std::exp2(2.0 * (2.0 * average - least - most) / (most - least));
}

double photographic_curve(double scaled_luminance, double white) noexcept {
    const double to_white = scaled_luminance / white;
    return (scaled_luminance + to_white * to_white) / (1.0 + scaled_luminance);
}

Adaptation own_adaptation(const ReinhardGlobal&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const ReinhardGlobal& mapper, const SceneLuminance& luminance, double adaptation_cdm2) {
    const double key = mapper.key > 0.0f ? double{mapper.key} : photographic_key(luminance);
    // The robust maximum costs a look at all pixels: only where it is wanted.
    const auto most = [&] { return key * luminance.robust_max_cdm2() / adaptation_cdm2; };
    const double white = mapper.white > 0.0f ? double{mapper.white} : most();
    // Ld / L without dividing by L, which may be 0.
    return {.exposure = [=](double adaptation) { return key / adaptation; },
            .compression = [=](double scaled) { return (1.0 + scaled / white / white) / (1.0 + scaled); }};
}

}  // namespace emulsion
