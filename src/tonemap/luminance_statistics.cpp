#include "tonemap/luminance_statistics.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/parallel.h"

namespace emulsion {

namespace {

/// Sum of natural logarithms: exponents are added, significands in [1, 2) multiplied, and ln is taken once in a while.
class LogSum {
  public:
    /// `value` is positive and finite; any float is a normal double.
    void add(float value) noexcept {
        const auto bits = std::bit_cast<std::uint64_t>(static_cast<double>(value));
        exponents_ += static_cast<std::int64_t>(bits >> 52u);
        product_ *= std::bit_cast<double>((bits & kSignificandBits) | kBitsOfOne);
        if (++count_ == kMaxFactors) flush();
    }

    [[nodiscard]] double sum() noexcept {
        flush();
        return sum_;
    }

  private:
    static constexpr int kMaxFactors = 256;  // 2^256 is far from overflow
    static constexpr std::uint64_t kSignificandBits = (std::uint64_t{1} << 52u) - 1;
    static constexpr std::uint64_t kBitsOfOne = std::uint64_t{1023} << 52u;

    void flush() noexcept {
        const auto exponent = static_cast<double>(exponents_ - std::int64_t{1023} * count_);
        sum_ += exponent * std::numbers::ln2 + std::log(product_);
        product_ = 1.0;
        exponents_ = 0;
        count_ = 0;
    }

    double sum_ = 0.0, product_ = 1.0;
    std::int64_t exponents_ = 0;
    int count_ = 0;
};

/// What is gathered over one row, and then over the rows in their order.
struct RowStatistics {
    double log_sum = 0.0;
    float min_positive = std::numeric_limits<float>::infinity();
    float max = 0.0f;
    PixelCounts counts;
    int first_bad_x = -1;  // -1: none
};

void count(PixelCounts& counts, PixelClass pixel_class) noexcept {
    switch (pixel_class) {
        case PixelClass::positive:
            ++counts.positive;
            break;
        case PixelClass::zero:
            ++counts.zero;
            break;
        case PixelClass::negative:
            ++counts.negative;
            break;
        case PixelClass::nan:
            ++counts.nan;
            break;
        case PixelClass::infinite:
            ++counts.infinite;
            break;
    }
}

RowStatistics statistics_of_row(std::span<const XYZ> row, LuminanceHistogram& histogram) noexcept {
    RowStatistics gathered;
    LogSum log_sum;
    for (std::size_t x = 0; x < row.size(); ++x) {
        const PixelClass pixel_class = classify(row[x]);
        if (pixel_class == PixelClass::positive) [[likely]] {
            const float luminance = row[x].y;
            log_sum.add(luminance);
            histogram.add(luminance);
            gathered.min_positive = std::min(gathered.min_positive, luminance);
            gathered.max = std::max(gathered.max, luminance);
            ++gathered.counts.positive;
            continue;
        }
        count(gathered.counts, pixel_class);
        if (pixel_class != PixelClass::zero && gathered.first_bad_x < 0) gathered.first_bad_x = static_cast<int>(x);
    }
    gathered.log_sum = log_sum.sum();
    return gathered;
}

PixelCounts operator+(const PixelCounts& a, const PixelCounts& b) noexcept {
    return {a.positive + b.positive, a.zero + b.zero, a.negative + b.negative, a.nan + b.nan, a.infinite + b.infinite};
}

LuminanceStatistics statistics_of_rows(std::span<const RowStatistics> rows) noexcept {
    RowStatistics total;
    LuminanceStatistics statistics;
    for (std::size_t y = 0; y < rows.size(); ++y) {
        const RowStatistics& row = rows[y];
        total.log_sum += row.log_sum;
        total.min_positive = std::min(total.min_positive, row.min_positive);
        total.max = std::max(total.max, row.max);
        total.counts = total.counts + row.counts;
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

/// How many pixels at each end of the range are outliers.
double outliers(const PixelCounts& counts) noexcept {
    const std::int64_t share = counts.positive / 1000;
    return static_cast<double>(share == 0 && counts.positive >= 64 ? 1 : share);
}

/// Parts of a picture that have a histogram each: few enough for their memory, enough for many threads. They depend on
/// the size of the picture alone.
int parts_of(ImageView<const XYZ> scene) noexcept {
    constexpr std::size_t kLeastPixels = std::size_t{1} << 16u, kMost = 64;
    const std::size_t parts = std::clamp(scene.pixels().size() / kLeastPixels, std::size_t{1}, kMost);
    return std::min(scene.height(), static_cast<int>(parts));
}

}  // namespace

// Of the values themselves the rank is a half more than how many are less: a whole one may lie in the gap between an
// outlier and the others.
double SceneLuminance::robust_min_cdm2() const noexcept {
    const double outside = outliers(statistics.counts);
    if (outside == 0.0) return statistics.min_positive_cdm2;
    return std::clamp(histogram.value_of_rank(outside + 0.5), statistics.min_positive_cdm2, statistics.max_cdm2);
}

double SceneLuminance::robust_max_cdm2() const noexcept {
    const double outside = outliers(statistics.counts);
    if (outside == 0.0) return statistics.max_cdm2;
    const double rank = static_cast<double>(statistics.counts.positive) - outside - 0.5;
    return std::clamp(histogram.value_of_rank(rank), statistics.min_positive_cdm2, statistics.max_cdm2);
}

SceneLuminance scene_luminance(ImageView<const XYZ> scene, int threads) {
    const int parts = parts_of(scene);
    std::vector<RowStatistics> rows(static_cast<std::size_t>(scene.height()));
    std::vector<LuminanceHistogram> histograms(static_cast<std::size_t>(parts));
    const auto first_row = [&](int part) { return static_cast<int>(std::int64_t{scene.height()} * part / parts); };
    parallel_for(0, parts, threads, [&](int part) {
        LuminanceHistogram& histogram = histograms[static_cast<std::size_t>(part)];
        for (int y = first_row(part); y < first_row(part + 1); ++y) {
            rows[static_cast<std::size_t>(y)] = statistics_of_row(scene.row(y), histogram);
        }
    });
    SceneLuminance result{statistics_of_rows(rows), {}};
    for (const LuminanceHistogram& histogram : histograms) result.histogram += histogram;
    return result;
}

LuminanceStatistics luminance_statistics(ImageView<const XYZ> scene, int threads) {
    return scene_luminance(scene, threads).statistics;
}

LuminanceStatistics luminance_statistics_reference(ImageView<const XYZ> scene) {
    LuminanceStatistics statistics;
    double log_sum = 0.0;
    statistics.min_positive_cdm2 = std::numeric_limits<double>::infinity();
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            const PixelClass pixel_class = classify(scene(x, y));
            count(statistics.counts, pixel_class);
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
