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
    SceneLuminance(ImageView<const XYZ> scene, int threads)
        : statistics_(luminance_statistics(scene, threads, histogram_)) {}
    /// With statistics that are known: those of a twin.
    SceneLuminance(ImageView<const XYZ> scene, const LuminanceStatistics& statistics, int threads)
        : statistics_(statistics) {
        (void)luminance_statistics(scene, threads, histogram_);
    }

    [[nodiscard]] const LuminanceStatistics& statistics() const noexcept { return statistics_; }

    /// Of the positive pixels: see luminance_statistics() for which of them.
    [[nodiscard]] const LuminanceHistogram& histogram() const noexcept { return histogram_; }

    /// The luminance that a share q in [0, 1] of the positive pixels do not reach; within a bin's width. 0 if there are
    /// none.
    [[nodiscard]] double quantile_cdm2(double q) const noexcept;

    /// The ends of the range without its outliers: the brightest and the darkest thousandth of the positive pixels,
    /// rounded down, but at least one of 64 or more. Operators for which papers take the largest or the least luminance
    /// take these, so that a single pixel does not decide about a picture. 0 if no pixel is positive.
    [[nodiscard]] double robust_min_cdm2() const noexcept;
    [[nodiscard]] double robust_max_cdm2() const noexcept;

  private:
    LuminanceHistogram histogram_;
    LuminanceStatistics statistics_;
};

}  // namespace emulsion
