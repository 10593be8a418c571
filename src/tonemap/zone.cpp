#include "tonemap/zone.h"

#include <cmath>

#include "core/middle_grey.h"

namespace emulsion {

namespace {

constexpr double kMiddleZone = 5.0;

/// Ld / L with a shoulder from `placed` on.
double compressed_over_scaled(double scaled, double placed, double white) noexcept {
    if (scaled <= placed) return 1.0;
    const double room = 1.0 - placed;
    const double above = (scaled - placed) / room;
    const double shoulder = above * (1.0 + above / white / white) / (1.0 + above);
    return (placed + room * shoulder) / scaled;
}

}  // namespace

double dynamic_range_zones(const SceneLuminance& luminance) {
    if (luminance.statistics().counts.positive == 0) return 0.0;
    return std::log2(luminance.robust_max_cdm2() / luminance.robust_min_cdm2());
}

Adaptation own_adaptation(const ZoneSystem&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const ZoneSystem& mapper, const SceneLuminance& luminance, double adaptation_cdm2) {
    const double placed = kMiddleGrey * std::exp2(double{mapper.zone} - kMiddleZone);
    const double given = mapper.grey;
    ToneReproduction reproduction{
        .exposure = [=](double adaptation) { return placed / (given > 0.0 ? given : adaptation); }};
    const double most = reproduction.exposure(adaptation_cdm2) * luminance.robust_max_cdm2();
    if (most <= 1.0) return reproduction;
    const double white = (most - placed) / (1.0 - placed);
    reproduction.compression = [=](double scaled) { return compressed_over_scaled(scaled, placed, white); };
    return reproduction;
}

}  // namespace emulsion
