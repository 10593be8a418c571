#pragma once
// The luminances of a picture that is to be mapped: statistics, and, for those who ask, how they are spread.

#include <optional>

#include "core/color.h"
#include "core/image.h"
#include "tonemap/luminance_histogram.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion {

/// Looks at the pixels again when the histogram is first asked for, as most operators need none: they must still be as
/// they were. For one thread at a time.
class SceneLuminance {
  public:
    /// Threads as in parallel_for; nothing depends on them. \throws std::invalid_argument if threads < 0.
    SceneLuminance(ImageView<const XYZ> scene, int threads);
    /// With statistics that are known: those of a twin.
    SceneLuminance(ImageView<const XYZ> scene, LuminanceStatistics statistics, int threads);

    [[nodiscard]] const LuminanceStatistics& statistics() const noexcept { return statistics_; }

    /// Of the positive pixels: of all of them, or of every fourth, the first in turn 0, 2, 1, 3 from row to row, of
    /// pictures of more than 2^18 pixels.
    [[nodiscard]] const LuminanceHistogram& histogram() const;

    /// The luminance that a share q in [0, 1] of the positive pixels do not reach; within a bin's width. 0 if there are
    /// none.
    [[nodiscard]] double quantile_cdm2(double q) const;

    /// The ends of the range without its outliers: the brightest and the darkest thousandth of the positive pixels,
    /// rounded down, but at least one of 64 or more. Operators for which papers take the largest or the least luminance
    /// take these, so that a single pixel does not decide about a picture. 0 if no pixel is positive.
    [[nodiscard]] double robust_min_cdm2() const;
    [[nodiscard]] double robust_max_cdm2() const;

  private:
    ImageView<const XYZ> scene_;
    int threads_;
    LuminanceStatistics statistics_;
    mutable std::optional<LuminanceHistogram> histogram_;
};

}  // namespace emulsion
