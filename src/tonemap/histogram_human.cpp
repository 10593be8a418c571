#include "tonemap/histogram_human.h"

#include <algorithm>
#include <utility>

#include "tonemap/detection_threshold.h"
#include "tonemap/histogram_adjustment.h"

namespace emulsion {

Adaptation own_adaptation(const HistogramHuman&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const HistogramHuman& mapper, const SceneLuminance& luminance, double) {
    const double peak = mapper.peak;
    // T(Ld) / Ld over T(Y) / Y: relative thresholds, as slopes are of logarithms.
    const auto relative_threshold = [](double cdm2) { return detection_threshold_cdm2(cdm2) / cdm2; };
    auto curve = adjusted_histogram(
        luminance, {.peak_cdm2 = peak, .contrast = mapper.contrast}, [&](double world_cdm2, double displayed_cdm2) {
            return std::min(1.0, relative_threshold(displayed_cdm2) / relative_threshold(world_cdm2));
        });
    if (!curve) {
        const double displayed = detection_threshold_cdm2(0.5 * peak), most = 1.0 / luminance.robust_max_cdm2();
        return {.exposure = [=](double adaptation) {
            return std::min(displayed / detection_threshold_cdm2(adaptation) / peak, most);
        }};
    }
    return {.exposure = [](double) { return 1.0; },
            .compression =
                [peak, curve = std::move(*curve)](double cdm2) { return curve.displayed_over_luminance(cdm2) / peak; }};
}

}  // namespace emulsion
