#include "tonemap/luminance_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/row_blocks.h"
#include "tonemap/luminance_rows.h"

namespace emulsion {

namespace {

LuminanceStatistics statistics_of_rows(std::span<const RowStatistics> rows) noexcept {
    RowStatistics total;
    LuminanceStatistics statistics;
    for (std::size_t y = 0; y < rows.size(); ++y) {
        const RowStatistics& row = rows[y];
        total.log_sum += row.log_sum;
        total.min_positive = std::min(total.min_positive, row.min_positive);
        total.max = std::max(total.max, row.max);
        total.counts += row.counts;
        if (row.first_bad_x >= 0 && !statistics.first_bad_px) {
            statistics.first_bad_px = {row.first_bad_x, static_cast<int>(y)};
        }
    }
    statistics.counts = total.counts;
    if (total.counts.positive == 0) return statistics;
    statistics.log_average_cdm2 = std::exp(total.log_sum / static_cast<double>(total.counts.positive));
    statistics.min_positive_cdm2 = total.min_positive;
    statistics.max_cdm2 = total.max;
    return statistics;
}

}  // namespace

LuminanceStatistics luminance_statistics(ImageView<const XYZ> scene, int threads) {
    std::vector<RowStatistics> rows(static_cast<std::size_t>(scene.height()));
    parallel_for_rows(scene.width(), scene.height(), threads,
                      [&](int y) { rows[static_cast<std::size_t>(y)] = statistics_of_row(scene.row(y)); });
    return statistics_of_rows(rows);
}

LuminanceStatistics luminance_statistics_reference(ImageView<const XYZ> scene) {
    LuminanceStatistics statistics;
    double log_sum = 0.0;
    statistics.min_positive_cdm2 = std::numeric_limits<double>::infinity();
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            const PixelClass pixel_class = classify(scene(x, y));
            statistics.counts.add(pixel_class);
            if (pixel_class == PixelClass::zero) continue;
            if (pixel_class != PixelClass::positive) {
                if (!statistics.first_bad_px) statistics.first_bad_px = {x, y};
                continue;
            }
            const double luminance = scene(x, y).y;
            log_sum += std::log(luminance);
            statistics.min_positive_cdm2 = std::min(statistics.min_positive_cdm2, luminance);
            statistics.max_cdm2 = std::max(statistics.max_cdm2, luminance);
        }
    }
    if (statistics.counts.positive == 0) {
        statistics.min_positive_cdm2 = 0.0;
        return statistics;
    }
    statistics.log_average_cdm2 = std::exp(log_sum / static_cast<double>(statistics.counts.positive));
    return statistics;
}

}  // namespace emulsion
