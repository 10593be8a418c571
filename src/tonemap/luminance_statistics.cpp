#include "tonemap/luminance_statistics.h"

#include <algorithm>
#include <array>
#include <atomic>
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
        total.max_component = std::max(total.max_component, row.max_component);
        total.counts += row.counts;
        if (row.first_bad_x >= 0 && !statistics.first_bad_px) {
            statistics.first_bad_px = {row.first_bad_x, static_cast<int>(y)};
        }
    }
    statistics.counts = total.counts;
    statistics.max_component = total.max_component;
    if (total.counts.positive == 0) return statistics;
    statistics.log_average_cdm2 = std::exp(total.log_sum / static_cast<double>(total.counts.positive));
    statistics.min_positive_cdm2 = total.min_positive;
    statistics.max_cdm2 = total.max;
    return statistics;
}

CountedGroups counted_groups(ImageView<const XYZ> scene, int y) noexcept {
    constexpr std::size_t kMostPixelsOfAll = std::size_t{1} << 19u;
    const std::size_t pixels = scene.pixels().size();
    if (pixels <= kMostPixelsOfAll) return {};
    if (pixels <= 4 * LuminanceHistogram::kMostValues) {
        constexpr std::array<std::size_t, 4> kFirst = {0, 2, 1, 3};
        return {kFirst[static_cast<std::size_t>(y) % kFirst.size()], kFirst.size()};
    }
    const std::size_t step = pixels / LuminanceHistogram::kMostValues + 1;
    return {static_cast<std::size_t>(y) % step, step};
}

}  // namespace

LuminanceStatistics luminance_statistics(ImageView<const XYZ> scene, int threads) {
    LuminanceHistogram histogram;
    return luminance_statistics(scene, threads, histogram);
}

LuminanceStatistics luminance_statistics(ImageView<const XYZ> scene, int threads, LuminanceHistogram& histogram) {
    std::vector<RowStatistics> rows(static_cast<std::size_t>(scene.height()));
    const RowBlocks blocks(scene.width(), scene.height());
    // A worker has a histogram of its own, and takes blocks until there are none: counts add up to the same whoever
    // counted them.
    const int workers =
        std::min(threads == 0 ? hardware_threads() : std::min(threads, hardware_threads()), blocks.count());
    std::vector<LuminanceHistogram> histograms(static_cast<std::size_t>(std::max(workers, 1)));
    std::atomic<int> next_block = 0;
    parallel_for(0, workers, threads, [&](int worker) {
        for (int block = next_block++; block < blocks.count(); block = next_block++) {
            for (int y = blocks.first_row(block); y < blocks.first_row(block + 1); ++y) {
                rows[static_cast<std::size_t>(y)] = statistics_of_row(scene.row(y), counted_groups(scene, y),
                                                                      histograms[static_cast<std::size_t>(worker)]);
            }
        }
    });
    for (const LuminanceHistogram& counted : histograms) histogram += counted;
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
            if (is_bad(pixel_class)) {
                if (!statistics.first_bad_px) statistics.first_bad_px = {x, y};
                continue;
            }
            statistics.max_component = std::max(statistics.max_component, double{max_component(scene(x, y))});
            if (pixel_class == PixelClass::zero) continue;
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
