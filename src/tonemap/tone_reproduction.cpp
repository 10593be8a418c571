#include "tonemap/tone_reproduction.h"

#include <algorithm>
#include <limits>

#include "tonemap/luminance_table.h"
#include "tonemap/scale_pixels.h"

namespace emulsion {

namespace {

/// Plain if no pixel is bad, and no component can come out past the limit. The scale may be up to twice as large: that
/// of the darkest pixels is at the lower end of a table's first cell. NaN where it is not known.
RowPixels row_pixels(const LuminanceStatistics& statistics, double most_scale) noexcept {
    const bool within = 2.0 * most_scale * statistics.max_component <= kMaxDisplayComponent;
    return statistics.counts.bad() == 0 && within ? RowPixels::plain : RowPixels::any;
}

double most_scale(const LuminanceTable& table) noexcept {
    return table.is_whole() ? table.most_value() : std::numeric_limits<double>::quiet_NaN();
}

/// One adaptation for all: the scale depends on the pixel's own luminance alone.
void reproduce_globally(const ToneReproduction& reproduction, const LuminanceStatistics& statistics,
                        double adaptation_cdm2, ImageView<const XYZ> scene, ImageView<XYZ> display,
                        const XYZ& display_white, int threads) {
    const auto exact_scale = [&](double luminance) { return reproduction.scale(luminance, adaptation_cdm2); };
    const auto exact_at = [&](std::size_t, int) { return exact_scale; };
    if (!reproduction.compression) {
        const float constant = narrow_or_nan(reproduction.exposure(adaptation_cdm2));
        const RowPixels pixels = row_pixels(statistics, constant);
        const auto scale_row_at = [=](int, auto in, auto out, LeftPixels& left) {
            scale_row(constant, in, out, pixels, left);
        };
        scale_pixels(scene, display, display_white, threads, scale_row_at, exact_at);
        return;
    }
    const LuminanceTable table(exact_scale, statistics.min_positive_cdm2, statistics.max_cdm2, threads);
    const RowPixels pixels = row_pixels(statistics, most_scale(table));
    const auto scale_row_at = [&](int, auto in, auto out, LeftPixels& left) {
        scale_row(table, in, out, pixels, left);
    };
    scale_pixels(scene, display, display_white, threads, scale_row_at, exact_at);
}

/// An adaptation for each pixel, held above the least positive luminance of the picture.
void reproduce_locally(const ToneReproduction& reproduction, const LuminanceStatistics& statistics,
                       const AdaptationLuminance& adaptation, ImageView<const XYZ> scene, ImageView<XYZ> display,
                       const XYZ& display_white, int threads) {
    const Image<float>& local = adaptation.local;
    const double unit = adaptation.uniform_cdm2;
    const double least = statistics.min_positive_cdm2 / unit, most = statistics.max_cdm2 / unit;
    const auto exposure_of = [&](double relative) { return reproduction.exposure(std::max(relative, least) * unit); };
    const auto exact_at = [&](std::size_t x, int y) {
        const double adaptation_cdm2 = std::max(double{local(static_cast<int>(x), y)}, least) * unit;
        return [&reproduction, adaptation_cdm2](double luminance) {
            return reproduction.scale(luminance, adaptation_cdm2);
        };
    };
    const LuminanceTable exposures(exposure_of, least, most, threads);
    if (!reproduction.compression) {
        const RowPixels pixels = row_pixels(statistics, most_scale(exposures));
        const auto scale_row_at = [&](int y, auto in, auto out, LeftPixels& left) {
            scale_row(exposures, local.row(y), in, out, pixels, left);
        };
        scale_pixels(scene, display, display_white, threads, scale_row_at, exact_at);
        return;
    }
    const LuminanceTable compressions(reproduction.compression, exposures.least_value() * statistics.min_positive_cdm2,
                                      exposures.most_value() * statistics.max_cdm2, threads);
    const RowPixels pixels = row_pixels(statistics, 2.0 * most_scale(exposures) * most_scale(compressions));
    const auto scale_row_at = [&](int y, auto in, auto out, LeftPixels& left) {
        scale_row(exposures, compressions, local.row(y), in, out, pixels, left);
    };
    scale_pixels(scene, display, display_white, threads, scale_row_at, exact_at);
}

}  // namespace

void reproduce(const ToneReproduction& reproduction, const LuminanceStatistics& statistics,
               const AdaptationLuminance& adaptation, ImageView<const XYZ> scene, ImageView<XYZ> display,
               const XYZ& display_white, int threads) {
    if (adaptation.local.width() == 0) {
        reproduce_globally(reproduction, statistics, adaptation.uniform_cdm2, scene, display, display_white, threads);
    } else {
        reproduce_locally(reproduction, statistics, adaptation, scene, display, display_white, threads);
    }
}

}  // namespace emulsion
