#include "tonemap/luminance_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tonemap/luminance_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "tonemap/pixel_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sum of natural logarithms of vectors of normal numbers.
class LogSum {
  public:
    // Written out: members' own initialisers are compiled without the instruction set.
    LogSum() noexcept
        : lower_(hn::Set(Doubles(), 1.0)),
          upper_(hn::Set(Doubles(), 1.0)),
          exponents_(hn::Zero(hn::RebindToSigned<Floats>())) {}

    void add(Vector values) noexcept {
        const hn::RebindToSigned<Floats> integers;
        const Floats floats;
        const auto bits = hn::BitCast(integers, values);
        exponents_ = hn::Add(exponents_, hn::ShiftRight<23>(bits));
        const auto significand = hn::Or(hn::And(bits, hn::Set(integers, 0x7fffff)), hn::Set(integers, 0x3f800000));
        const auto factors = hn::BitCast(floats, significand);
        lower_ = hn::Mul(lower_, hn::PromoteTo(Doubles(), hn::LowerHalf(factors)));
        upper_ = hn::Mul(upper_, hn::PromoteTo(Doubles(), hn::UpperHalf(hn::Half<Floats>(), factors)));
        if (++count_ == kMostFactors / static_cast<int>(hn::Lanes(floats))) flush();
    }

    [[nodiscard]] double sum() noexcept {
        flush();
        return sum_;
    }

  private:
    using Doubles = hn::Repartition<double, Floats>;
    static constexpr int kMostFactors = 960;  // in [1, 2): a product below 2^960

    void flush() noexcept {
        const hn::RebindToSigned<Floats> integers;
        const auto lanes = static_cast<int>(hn::Lanes(Floats()));
        const int exponent = hn::GetLane(hn::SumOfLanes(integers, exponents_)) - 127 * count_ * lanes;
        std::array<double, hn::MaxLanes(Doubles())> factors{};
        hn::StoreU(hn::Mul(lower_, upper_), Doubles(), factors.data());
        double product = 1.0;
        for (std::size_t i = 0; i < hn::Lanes(Doubles()); ++i) product *= factors[i];
        sum_ += exponent * std::numbers::ln2 + std::log(product);
        exponents_ = hn::Zero(integers);
        lower_ = upper_ = hn::Set(Doubles(), 1.0);
        count_ = 0;
    }

    double sum_ = 0.0;
    hn::Vec<Doubles> lower_, upper_;
    hn::Vec<hn::RebindToSigned<Floats>> exponents_;
    int count_ = 0;
};

/// What pixels are added to.
struct RowSums {
    RowStatistics& statistics;
    const CountedGroups& counted;
    LuminanceHistogram& histogram;
};

void add_pixel(const XYZ& pixel, std::size_t x, const RowSums& sums) noexcept {
    RowStatistics& row = sums.statistics;
    const PixelClass pixel_class = classify(pixel);
    row.counts.add(pixel_class);
    if (pixel_class == PixelClass::zero) return;
    if (pixel_class != PixelClass::positive) {
        if (row.first_bad_x < 0) row.first_bad_x = static_cast<int>(x);
        return;
    }
    row.log_sum += std::log(double{pixel.y});
    row.min_positive = std::min(row.min_positive, pixel.y);
    row.max = std::max(row.max, pixel.y);
    if (sums.counted.has(x)) sums.histogram.add(pixel.y);
}

/// In whatever order the lanes are.
void count_lanes(Vector luminances, bool some_are_zero, LuminanceHistogram& histogram) noexcept {
    std::array<float, hn::MaxLanes(Floats())> values{};
    hn::StoreU(luminances, Floats(), values.data());
    for (std::size_t i = 0; i < hn::Lanes(Floats()); ++i) {
        if (!some_are_zero || values[i] > 0.0f) histogram.add(values[i]);
    }
}

/// Statistics of whole vectors of pixels whose luminances are 0 or normal numbers, and whose components are finite.
class VectorStatistics {
  public:
    VectorStatistics() : min_(hn::Set(Floats(), std::numeric_limits<float>::infinity())), max_(hn::Zero(Floats())) {}

    /// The vectors from pixel x on, up to the first that has another pixel, or that would be past the end. Returns
    /// where that one begins.
    std::size_t add(std::size_t x, std::span<const XYZ> row, const RowSums& sums) {
        static_assert(CountedGroups::kPixels % hn::MaxLanes(Floats()) == 0);
        const Floats tag;
        const std::size_t lanes = hn::Lanes(tag);
        const PixelLanes pixel_lanes;
        const auto largest = hn::Set(tag, std::numeric_limits<float>::max());
        const auto least_normal = hn::Set(tag, std::numeric_limits<float>::min());
        const auto is_finite = [&](Vector v) { return hn::Le(hn::Abs(v), largest); };
        for (; x + lanes <= row.size(); x += lanes) {
            const PixelVectors pixels(&row[x].x);
            const auto luminances = pixel_lanes.some_luminances(pixels);
            const auto is_normal = hn::Ge(luminances, least_normal);
            const auto is_zero = hn::Eq(luminances, hn::Zero(tag));
            const auto finite = hn::And(is_finite(pixels.a), hn::And(is_finite(pixels.b), is_finite(pixels.c)));
            if (!hn::AllTrue(tag, hn::And(hn::Or(is_normal, is_zero), finite))) break;
            const auto zeros = static_cast<std::int64_t>(hn::CountTrue(tag, is_zero));
            if (sums.counted.has(x)) count_lanes(luminances, zeros > 0, sums.histogram);
            zeros_ += zeros;
            max_ = hn::Max(max_, luminances);
            min_ = hn::Min(min_, hn::IfThenElse(is_zero, min_, luminances));
            log_sum_.add(hn::IfThenElse(is_zero, hn::Set(tag, 1.0f), luminances));
            pixels_ += static_cast<std::int64_t>(lanes);
        }
        return x;
    }

    void add_to(RowStatistics& row) {
        row.min_positive = std::min(row.min_positive, hn::GetLane(hn::MinOfLanes(Floats(), min_)));
        row.max = std::max(row.max, hn::GetLane(hn::MaxOfLanes(Floats(), max_)));
        row.counts.positive += pixels_ - zeros_;
        row.counts.zero += zeros_;
        row.log_sum += log_sum_.sum();
    }

  private:
    std::int64_t pixels_ = 0, zeros_ = 0;
    Vector min_, max_;
    LogSum log_sum_;
};

RowStatistics gather(std::span<const XYZ> row, const CountedGroups& counted, LuminanceHistogram& histogram) {
    RowStatistics statistics;
    const RowSums sums{statistics, counted, histogram};
    VectorStatistics of_vectors;
    for (std::size_t x = 0; x < row.size();) {
        x = of_vectors.add(x, row, sums);
        const std::size_t end = std::min(x + hn::Lanes(Floats()), row.size());
        for (; x < end; ++x) add_pixel(row[x], x, sums);
    }
    of_vectors.add_to(statistics);
    return statistics;
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {
HWY_EXPORT(gather);
}

RowStatistics statistics_of_row(std::span<const XYZ> row, const CountedGroups& counted,
                                LuminanceHistogram& histogram) noexcept {
    return HWY_DYNAMIC_DISPATCH(gather)(row, counted, histogram);
}

}  // namespace emulsion
#endif
