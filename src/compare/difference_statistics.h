#pragma once
// A picture of colour differences in a few numbers.

#include <cstdint>

#include "core/image.h"

namespace emulsion {

/// Over the pixels that have a difference. A percentile is the least of their values that so many in a hundred of them
/// do not exceed (nearest rank): one of the values itself, exact.
struct DifferenceStatistics {
    std::int64_t pixels = 0;  ///< that have one; all else is 0 if there are none
    double mean = 0.0, p50 = 0.0, p99 = 0.0, max = 0.0;
    int max_x = 0, max_y = 0;  ///< the first pixel in reading order with the largest
    bool operator==(const DifferenceStatistics&) const = default;
};

/// \param differences >= 0, or NaN for pixels that have none
[[nodiscard]] DifferenceStatistics difference_statistics(ImageView<const double> differences);

}  // namespace emulsion
