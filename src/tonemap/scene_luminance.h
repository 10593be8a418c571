#pragma once
// The luminances of a picture that is to be mapped: statistics, and how they are spread.

#include "core/color.h"
#include "core/image.h"
#include "tonemap/luminance_histogram.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion {

class SceneLuminance {
  public:
    /// Threads as in parallel_for; nothing depends on them. \throws std::invalid_argument if threads < 0.
    SceneLuminance(ImageView<const XYZ> scene, int threads);
    /// With statistics that are known: those of a twin.
    SceneLuminance(ImageView<const XYZ> scene, LuminanceStatistics statistics, int threads);

    [[nodiscard]] const LuminanceStatistics& statistics() const noexcept { return statistics_; }

    /// Of the positive pixels: see luminance_statistics() for which of them.
    [[nodiscard]] const LuminanceHistogram& histogram() const noexcept { return histogram_; }

    /// The luminance that a share q in [0, 1] of the positive pixels do not reach; within a bin's width. 0 if there are
    /// none.
    [[nodiscard]] double quantile_cdm2(double q) const noexcept;

    /// The ends of the range without its outliers: without the brightest and the darkest thousandth of the pixels that
    /// are not black, rounded down, but at least one of 64 or more; those that are a thousand times beyond the ends are
    /// left out before. Within the width of one bin. Operators for which papers take the largest or the least luminance
    /// take these, so that a single pixel does not decide about a picture. 0 if no pixel is positive.
    [[nodiscard]] double robust_min_cdm2() const noexcept { return robust_min_cdm2_; }
    [[nodiscard]] double robust_max_cdm2() const noexcept { return robust_max_cdm2_; }

    /// Luminances from the one on, or up to the other, are outliers: a thousand times beyond the robust ends.
    [[nodiscard]] double least_outlier_cdm2() const noexcept { return kOutlierRatio * robust_max_cdm2_; }
    [[nodiscard]] double most_dark_outlier_cdm2() const noexcept { return robust_min_cdm2_ / kOutlierRatio; }

    /// exp(mean of ln Y) over the positive pixels. Of small pictures, which one pixel could move by 0.1 % or more,
    /// without outliers.
    [[nodiscard]] double log_average_cdm2() const noexcept { return log_average_cdm2_; }

  private:
    static constexpr double kOutlierRatio = 1000.0;

    void find_ends() noexcept;
    [[nodiscard]] double log_average_without_outliers() const noexcept;

    LuminanceHistogram histogram_;
    LuminanceStatistics statistics_;
    double robust_min_cdm2_ = 0.0, robust_max_cdm2_ = 0.0, log_average_cdm2_ = 0.0;
};

}  // namespace emulsion
