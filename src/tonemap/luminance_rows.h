#pragma once
// The inner loop of the luminance statistics: one row of pixels.

#include <cstddef>
#include <limits>
#include <span>

#include "core/color.h"
#include "tonemap/luminance_histogram.h"
#include "tonemap/pixel_class.h"

namespace emulsion {

/// What is gathered over one row.
struct RowStatistics {
    double log_sum = 0.0;  ///< of ln Y over the positive pixels
    float min_positive = std::numeric_limits<float>::infinity();
    float max = 0.0f;
    float max_component = 0.0f;  ///< of good pixels
    PixelCounts counts;
    int first_bad_x = -1;  ///< -1: none
};

/// The groups of pixels of a row whose luminances go into a histogram: of every `step` the first after `first` others.
struct CountedGroups {
    static constexpr std::size_t kPixels = 16;  ///< of a group; the last one of a row may have fewer
    std::size_t first = 0, step = 1;

    [[nodiscard]] bool has(std::size_t x) const noexcept { return x / kPixels % step == first; }
};

/// In vectors as wide as the processor has. Numbers are multiplied, their exponents taken out and added in time, and ln
/// is taken once: the log sum is within 2e-16 for each pixel. The positive luminances of the groups that count are
/// added to `histogram`.
[[nodiscard]] RowStatistics statistics_of_row(std::span<const XYZ> row, const CountedGroups& counted,
                                              LuminanceHistogram& histogram) noexcept;

}  // namespace emulsion
