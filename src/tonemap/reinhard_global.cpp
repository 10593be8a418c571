#include "tonemap/reinhard_global.h"

#include "tonemap/scale_pixels.h"

namespace emulsion {

namespace {

/// L / Y; 0 if the picture has no positive pixel.
double exposure(const ReinhardGlobal& mapper, const LuminanceStatistics& statistics) noexcept {
    return statistics.log_average_cdm2 > 0.0 ? mapper.key / statistics.log_average_cdm2 : 0.0;
}

}  // namespace

double display_luminance(const ReinhardGlobal& mapper, double scaled_luminance) noexcept {
    const double to_white = scaled_luminance / mapper.white;
    return (scaled_luminance + to_white * to_white) / (1.0 + scaled_luminance);
}

double luminance_scale(const ReinhardGlobal& mapper, const LuminanceStatistics& statistics,
                       double luminance_cdm2) noexcept {
    const double scaling = exposure(mapper, statistics);
    const double scaled = scaling * luminance_cdm2;
    // Ld / Y without dividing by Y, which may be 0.
    return scaling * (1.0 + scaled / mapper.white / mapper.white) / (1.0 + scaled);
}

void apply(const ReinhardGlobal& mapper, const LuminanceStatistics& statistics, ImageView<const XYZ> scene,
           ImageView<XYZ> display, const XYZ& display_white, int threads) {
    const float scaling = narrow_or_nan(exposure(mapper, statistics));
    const float inverse_white2 = narrow_or_nan(1.0 / mapper.white / mapper.white);
    const auto fast_scale = [=](float luminance) noexcept {
        const float scaled = scaling * luminance;
        return scaling * (1.0f + scaled * inverse_white2) / (1.0f + scaled);
    };
    const auto exact_scale = [&](double luminance) noexcept { return luminance_scale(mapper, statistics, luminance); };
    scale_pixels(scene, display, display_white, threads, fast_scale, exact_scale);
}

}  // namespace emulsion
