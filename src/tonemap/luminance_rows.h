#pragma once
// The inner loop of the luminance statistics: one row of pixels.

#include <limits>
#include <span>

#include "core/color.h"
#include "tonemap/pixel_class.h"

namespace emulsion {

/// What is gathered over one row.
struct RowStatistics {
    double log_sum = 0.0;  ///< of ln Y over the positive pixels
    float min_positive = std::numeric_limits<float>::infinity();
    float max = 0.0f;
    PixelCounts counts;
    int first_bad_x = -1;  ///< -1: none
};

/// In vectors as wide as the processor has. Exponents are added and significands multiplied, ln being taken of products
/// of up to 960 of them: the log sum is within 1e-14 of the sum of its terms' magnitudes.
[[nodiscard]] RowStatistics statistics_of_row(std::span<const XYZ> row) noexcept;

}  // namespace emulsion
