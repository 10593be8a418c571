#include "tonemap/reinhard_global.h"

#include <algorithm>
#include <cmath>

#include "core/middle_grey.h"

namespace emulsion {

namespace {

/// log2 of cd/m^2.
struct Ends {
    double least, most;
};

Ends ends_of(const SceneLuminance& luminance) noexcept {
    constexpr double kLeftOut = 0.01;
    return {std::log2(std::max(luminance.quantile_cdm2(kLeftOut), luminance.robust_min_cdm2())),
            std::log2(std::min(luminance.quantile_cdm2(1.0 - kLeftOut), luminance.robust_max_cdm2()))};
}

}  // namespace

double photographic_key(const SceneLuminance& luminance) {
    const double average = std::log2(luminance.log_average_cdm2());
    const Ends ends = ends_of(luminance);
    if (!(ends.most > ends.least)) return kMiddleGrey;
    return kMiddleGrey * std::exp2(2.0 * (2.0 * average - ends.least - ends.most) / (ends.most - ends.least));
}

double photographic_white(const SceneLuminance& luminance, double key) {
    const Ends ends = ends_of(luminance);
    return std::max(1.5 * std::exp2(ends.most - ends.least - 5.0), key);
}

Adaptation own_adaptation(const ReinhardGlobal&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const ReinhardGlobal& mapper, const SceneLuminance& luminance, double adaptation_cdm2) {
    const double key = mapper.key > 0.0f ? double{mapper.key} : photographic_key(luminance);
    double white = mapper.white;
    if (mapper.white == ReinhardGlobal::kAutoWhite) white = photographic_white(luminance, key);
    if (mapper.white == ReinhardGlobal::kMaxWhite) white = key * luminance.robust_max_cdm2() / adaptation_cdm2;
    // Ld / L without dividing by L, which may be 0.
    return {.exposure = [=](double adaptation) { return key / adaptation; },
            .compression = [=](double scaled) { return (1.0 + scaled / white / white) / (1.0 + scaled); }};
}

}  // namespace emulsion
