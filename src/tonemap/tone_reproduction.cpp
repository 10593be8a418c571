#include "tonemap/tone_reproduction.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

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
MapStretch reproduce_globally(const ToneReproduction& reproduction, const LuminanceStatistics& statistics,
                              double adaptation_cdm2, const XYZ& display_white, int threads) {
    const auto exact_scale = [=](double luminance) { return reproduction.scale(luminance, adaptation_cdm2); };
    const auto exact_at = [=](std::size_t) -> const auto& { return exact_scale; };
    if (!reproduction.compression) {
        const float constant = narrow_or_nan(reproduction.exposure(adaptation_cdm2));
        const RowPixels pixels = row_pixels(statistics, constant);
        const auto scale = [=](auto in, auto out, LeftPixels& left) { scale_row(constant, in, out, pixels, left); };
        return
            [=](int, int, auto scene, auto display) { scale_pixels(scene, display, display_white, scale, exact_at); };
    }
    const LuminanceTable table(exact_scale, statistics.min_positive_cdm2, statistics.max_cdm2, threads);
    const RowPixels pixels = row_pixels(statistics, most_scale(table));
    return [=](int, int, auto scene, auto display) {
        const auto scale = [&](auto in, auto out, LeftPixels& left) { scale_row(table, in, out, pixels, left); };
        scale_pixels(scene, display, display_white, scale, exact_at);
    };
}

/// An adaptation for each pixel, held above the least positive luminance of the picture.
class LocalReproduction {
  public:
    LocalReproduction(ToneReproduction reproduction, const LuminanceStatistics& statistics,
                      AdaptationLuminance adaptation, const XYZ& display_white, int threads)
        : reproduction_(std::move(reproduction)),
          local_(std::move(adaptation.local)),
          display_white_(display_white),
          unit_(adaptation.uniform_cdm2),
          least_(statistics.min_positive_cdm2 / unit_),
          exposures_([&](double relative) { return reproduction_.exposure(adaptation_cdm2(relative)); }, least_,
                     statistics.max_cdm2 / unit_, threads) {
        if (!reproduction_.compression) {
            pixels_ = row_pixels(statistics, most_scale(exposures_));
            return;
        }
        compressions_.emplace(reproduction_.compression, exposures_.least_value() * statistics.min_positive_cdm2,
                              exposures_.most_value() * statistics.max_cdm2, threads);
        pixels_ = row_pixels(statistics, 2.0 * most_scale(exposures_) * most_scale(*compressions_));
    }

    void operator()(int y, int x0, std::span<const XYZ> scene, std::span<XYZ> display) const {
        const std::span<const float> local = local_.row(y).subspan(static_cast<std::size_t>(x0), scene.size());
        const auto scale = [&](auto in, auto out, LeftPixels& left) {
            if (compressions_) return scale_row(exposures_, *compressions_, local, in, out, pixels_, left);
            scale_row(exposures_, local, in, out, pixels_, left);
        };
        scale_pixels(scene, display, display_white_, scale, [&](std::size_t i) {
            return [this, here = adaptation_cdm2(local[i])](double luminance) {
                return reproduction_.scale(luminance, here);
            };
        });
    }

  private:
    [[nodiscard]] double adaptation_cdm2(double relative) const noexcept { return std::max(relative, least_) * unit_; }

    ToneReproduction reproduction_;
    Image<float> local_;
    XYZ display_white_;
    double unit_, least_;
    LuminanceTable exposures_;
    std::optional<LuminanceTable> compressions_;
    RowPixels pixels_ = RowPixels::any;
};

}  // namespace

MapStretch reproduce(const ToneReproduction& reproduction, const LuminanceStatistics& statistics,
                     AdaptationLuminance adaptation, const XYZ& display_white, int threads) {
    if (adaptation.local.width() == 0) {
        return reproduce_globally(reproduction, statistics, adaptation.uniform_cdm2, display_white, threads);
    }
    const auto local = std::make_shared<const LocalReproduction>(reproduction, statistics, std::move(adaptation),
                                                                 display_white, threads);
    return [local](int y, int x0, auto scene, auto display) { (*local)(y, x0, scene, display); };
}

}  // namespace emulsion
