#include "tonemap/max_to_white.h"

#include "tonemap/scale_pixels.h"

namespace emulsion {

double luminance_scale(const MaxToWhite& /*mapper*/, const LuminanceStatistics& statistics,
                       double /*luminance_cdm2*/) noexcept {
    return statistics.max_cdm2 > 0.0 ? 1.0 / statistics.max_cdm2 : 0.0;
}

void apply(const MaxToWhite& mapper, const LuminanceStatistics& statistics, ImageView<const XYZ> scene,
           ImageView<XYZ> display, const XYZ& display_white, int threads) {
    const double exact = luminance_scale(mapper, statistics, 0.0);
    const float fast = narrow_or_nan(exact);
    scale_pixels(
        scene, display, display_white, threads, [=](float) noexcept { return fast; },
        [=](double) noexcept { return exact; });
}

}  // namespace emulsion
