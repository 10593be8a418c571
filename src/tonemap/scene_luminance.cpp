#include "tonemap/scene_luminance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace emulsion {

namespace {

constexpr std::size_t kMostPixelsOfAll = std::size_t{1} << 18u;

void add_row(std::span<const XYZ> row, std::size_t first, std::size_t step, LuminanceHistogram& histogram) noexcept {
    for (std::size_t x = first; x < row.size(); x += step) {
        if (classify(row[x]) == PixelClass::positive) histogram.add(row[x].y);
    }
}

/// How many of `count` values lie beyond each robust end.
double outliers(double count) noexcept {
    const double share = std::floor(count / 1000.0);
    return share == 0.0 && count >= 64.0 ? 1.0 : share;
}

}  // namespace

SceneLuminance::SceneLuminance(ImageView<const XYZ> scene, int threads)
    : SceneLuminance(scene, luminance_statistics(scene, threads), threads) {}

SceneLuminance::SceneLuminance(ImageView<const XYZ> scene, LuminanceStatistics statistics, int threads)
    : scene_(scene), threads_(threads), statistics_(std::move(statistics)) {}

const LuminanceHistogram& SceneLuminance::histogram() const {
    if (histogram_) return *histogram_;
    const std::size_t pixels = scene_.pixels().size(), step = pixels > kMostPixelsOfAll ? 4 : 1;
    // Parts that have a histogram each: few enough for their memory, enough for many threads.
    const int parts =
        std::min(scene_.height(), static_cast<int>(std::clamp(pixels >> 16u, std::size_t{1}, std::size_t{64})));
    std::vector<LuminanceHistogram> histograms(static_cast<std::size_t>(parts));
    const auto first_row = [&](int part) { return static_cast<int>(std::int64_t{scene_.height()} * part / parts); };
    parallel_for(0, parts, threads_, [&](int part) {
        constexpr std::array<std::size_t, 4> kFirst = {0, 2, 1, 3};
        for (int y = first_row(part); y < first_row(part + 1); ++y) {
            const std::size_t first = step == 1 ? 0 : kFirst[static_cast<std::size_t>(y) % kFirst.size()];
            add_row(scene_.row(y), first, step, histograms[static_cast<std::size_t>(part)]);
        }
    });
    histogram_.emplace();
    for (const LuminanceHistogram& histogram : histograms) *histogram_ += histogram;
    return *histogram_;
}

double SceneLuminance::quantile_cdm2(double q) const {
    const double value = histogram().value_of_rank(q * static_cast<double>(histogram().total()));
    return std::clamp(value, statistics_.min_positive_cdm2, statistics_.max_cdm2);
}

// Of the values themselves the rank is a half more than how many are less: a whole one may lie in the gap between an
// outlier and the others.
double SceneLuminance::robust_min_cdm2() const {
    const auto count = static_cast<double>(histogram().total());
    const double outside = outliers(count);
    return outside == 0.0 ? statistics_.min_positive_cdm2 : quantile_cdm2((outside + 0.5) / count);
}

double SceneLuminance::robust_max_cdm2() const {
    const auto count = static_cast<double>(histogram().total());
    const double outside = outliers(count);
    return outside == 0.0 ? statistics_.max_cdm2 : quantile_cdm2((count - outside - 0.5) / count);
}

}  // namespace emulsion
