#include "tonemap/scene_luminance.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace emulsion {

namespace {

/// How many pixels of a picture lie beyond each robust end. Bad pixels count, so that it does not move when a pixel
/// goes bad; zeros do not, so that black borders don't.
double outliers(const PixelCounts& counts) noexcept {
    const auto all = static_cast<double>(counts.positive + counts.bad());
    const double share = std::floor(all / 1000.0);
    const double most = std::floor(static_cast<double>(counts.positive) / 64.0);
    return std::min(std::max(share, 1.0), most);
}

/// How many values lie in bins that wholly are at or above `luminance`, or below it.
double values_above(const LuminanceHistogram& histogram, double luminance) noexcept {
    double count = 0.0;
    for (int bin = LuminanceHistogram::kBins - 1; bin >= 0; --bin) {
        if (LuminanceHistogram::lower_end(bin) < luminance) break;
        count += static_cast<double>(histogram.count(bin));
    }
    return count;
}

double values_below(const LuminanceHistogram& histogram, double luminance) noexcept {
    double count = 0.0;
    for (int bin = 0; bin < LuminanceHistogram::kBins && LuminanceHistogram::lower_end(bin + 1) <= luminance; ++bin) {
        count += static_cast<double>(histogram.count(bin));
    }
    return count;
}

}  // namespace

SceneLuminance::SceneLuminance(ImageView<const XYZ> scene, int threads)
    : statistics_(luminance_statistics(scene, threads, histogram_)) {
    find_ends();
}

SceneLuminance::SceneLuminance(ImageView<const XYZ> scene, LuminanceStatistics statistics, int threads)
    : statistics_(std::move(statistics)) {
    (void)luminance_statistics(scene, threads, histogram_);
    find_ends();
}

void SceneLuminance::find_ends() noexcept {
    robust_min_cdm2_ = statistics_.min_positive_cdm2;
    robust_max_cdm2_ = statistics_.max_cdm2;
    const double outside = outliers(statistics_.counts);
    if (outside > 0.0) {
        // The histogram may have a part of the pixels only.
        const auto total = static_cast<double>(histogram_.total());
        const double values = outside * total / static_cast<double>(statistics_.counts.positive);
        const auto value = [&](double rank) {
            const double found = histogram_.value_of_rank(rank);
            return std::clamp(found, statistics_.min_positive_cdm2, statistics_.max_cdm2);
        };
        // A half more than a whole number lie below a value itself: a whole one may lie in the gap beside an outlier.
        robust_max_cdm2_ = value(total - values - 0.5);
        robust_max_cdm2_ = value(total - values_above(histogram_, kOutlierRatio * robust_max_cdm2_) - values - 0.5);
        robust_min_cdm2_ = value(values + 0.5);
        robust_min_cdm2_ = value(values_below(histogram_, robust_min_cdm2_ / kOutlierRatio) + values + 0.5);
    }
    log_average_cdm2_ = log_average_without_outliers();
}

double SceneLuminance::log_average_without_outliers() const noexcept {
    const double average = statistics_.log_average_cdm2,
                 least_influence = 1e-3 * static_cast<double>(statistics_.counts.positive);
    if (!(average > 0.0)) return average;
    const bool moves = std::log(statistics_.max_cdm2 / average) >= least_influence ||
                       std::log(average / statistics_.min_positive_cdm2) >= least_influence;
    if (!moves) return average;
    double left_out = 0.0, log_sum = 0.0;  // of ln(Y / average)
    const auto leave_out = [&](int bin) {
        const auto count = static_cast<double>(histogram_.count(bin));
        if (count == 0.0) return;
        left_out += count;
        log_sum += count * std::log(histogram_.mean(bin) / average);
    };
    for (int bin = 0; bin < LuminanceHistogram::kBins; ++bin) {
        if (LuminanceHistogram::lower_end(bin + 1) <= most_dark_outlier_cdm2() ||
            LuminanceHistogram::lower_end(bin) >= least_outlier_cdm2()) {
            leave_out(bin);
        }
    }
    return average * std::exp(-log_sum / (static_cast<double>(statistics_.counts.positive) - left_out));
}

double SceneLuminance::quantile_cdm2(double q) const noexcept {
    const double value = histogram_.value_of_rank(q * static_cast<double>(histogram_.total()));
    return std::clamp(value, statistics_.min_positive_cdm2, statistics_.max_cdm2);
}

}  // namespace emulsion
