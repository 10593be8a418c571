#pragma once
// What an operator needs to know about a whole picture: luminances in cd/m^2, and how many pixels of each class.

#include <optional>
#include <utility>

#include "core/color.h"
#include "core/image.h"
#include "tonemap/luminance_histogram.h"
#include "tonemap/pixel_class.h"

namespace emulsion {

struct LuminanceStatistics {
    /// exp(mean of ln Y) over the positive pixels; 0 if there are none. Zeros are left out of both sum and count, so
    /// that the result scales with the unit. The paper's ln(delta + Y) does not: its delta is a luminance.
    double log_average_cdm2 = 0.0;
    double min_positive_cdm2 = 0.0;  ///< least positive luminance; 0 if there is none
    double max_cdm2 = 0.0;           ///< largest; 0 if no pixel is positive
    double max_component = 0.0;      ///< largest |X|, |Y| or |Z| of good pixels
    PixelCounts counts;
    std::optional<std::pair<int, int>> first_bad_px;  ///< (x, y) of the first bad pixel in reading order
    bool operator==(const LuminanceStatistics&) const = default;
};

/// Sums in double precision, row by row in a fixed order: the same bits for every number of threads (0: all).
/// log-average within 1e-12 of the twin, relative.
/// Source: Reinhard et al. 2002, eq. 1, with 1/N inside the exponential, where it belongs, and without delta.
/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] LuminanceStatistics luminance_statistics(ImageView<const XYZ> scene, int threads);

/// The same, and adds luminances to `histogram`: those of all positive pixels; of pictures of more than 2^19 pixels, of
/// every fourth group of 16 in a row, the first in turn 0, 2, 1, 3 from row to row; of fewer in pictures of more than
/// 2^29, so that no bin can have too many.
[[nodiscard]] LuminanceStatistics luminance_statistics(ImageView<const XYZ> scene, int threads,
                                                       LuminanceHistogram& histogram);

/// The double-precision twin: one ln for each pixel, one running sum.
[[nodiscard]] LuminanceStatistics luminance_statistics_reference(ImageView<const XYZ> scene);

}  // namespace emulsion
