#include "tonemap/histogram.h"

#include <utility>

#include "tonemap/histogram_adjustment.h"

namespace emulsion {

Adaptation own_adaptation(const HistogramAdjustment&) noexcept { return LogAverageAdaptation{}; }

ToneReproduction prepare(const HistogramAdjustment& mapper, const SceneLuminance& luminance, double) {
    auto curve = adjusted_histogram(luminance, {.peak_cdm2 = 1.0, .contrast = mapper.contrast},
                                    [](double, double) { return 1.0; });
    if (!curve) return {.exposure = [scale = 1.0 / luminance.robust_max_cdm2()](double) { return scale; }};
    return {.exposure = [](double) { return 1.0; },
            .compression = [curve = std::move(*curve)](double cdm2) { return curve.displayed_over_luminance(cdm2); }};
}

}  // namespace emulsion
