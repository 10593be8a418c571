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
        : lower_(hn::Set(Doubles(), 1.0)), upper_(hn::Set(Doubles(), 1.0)), exponents_(hn::Zero(Integers())) {}

    void add(Vector values) noexcept {
        lower_ = hn::Mul(lower_, hn::PromoteTo(Doubles(), hn::LowerHalf(values)));
        upper_ = hn::Mul(upper_, hn::PromoteTo(Doubles(), hn::UpperHalf(hn::Half<Floats>(), values)));
        if (++factors_ == kMostFactors) take_exponents();
    }

    /// What was added; more must not be.
    [[nodiscard]] double sum() noexcept {
        take_exponents();
        const std::int64_t exponent = hn::GetLane(hn::SumOfLanes(Integers(), exponents_)) -
                                      1023 * taken_ * static_cast<std::int64_t>(hn::Lanes(Doubles()));
        std::array<double, 2 * hn::MaxLanes(Doubles())> products{};
        hn::StoreU(lower_, Doubles(), products.data());
        hn::StoreU(upper_, Doubles(), products.data() + hn::Lanes(Doubles()));
        double product = 1.0;
        for (std::size_t i = 0; i < 2 * hn::Lanes(Doubles()); ++i) product *= products[i];
        return static_cast<double>(exponent) * std::numbers::ln2 + std::log(product);
    }

  private:
    using Doubles = hn::Repartition<double, Floats>;
    using Integers = hn::Repartition<std::int64_t, Floats>;
    using Products = hn::Vec<Doubles>;
    static constexpr int kMostFactors = 7;  // each in [2^-126, 2^128): beside one in [1, 2) still normal

    void take_exponents() noexcept {
        lower_ = without_exponent(lower_);
        upper_ = without_exponent(upper_);
        taken_ += 2;
        factors_ = 0;
    }

    [[nodiscard]] Products without_exponent(Products product) noexcept {
        constexpr std::int64_t kSignificand = (std::int64_t{1} << 52) - 1, kOne = std::int64_t{1023} << 52;
        const Integers integers;
        const auto bits = hn::BitCast(integers, product);
        exponents_ = hn::Add(exponents_, hn::ShiftRight<52>(bits));
        const auto significand = hn::And(bits, hn::Set(integers, kSignificand));
        return hn::BitCast(Doubles(), hn::Or(significand, hn::Set(integers, kOne)));
    }

    Products lower_, upper_;
    hn::Vec<Integers> exponents_;
    std::int64_t taken_ = 0;  ///< how many vectors of exponents were
    int factors_ = 0;
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
    if (is_bad(pixel_class)) {
        if (row.first_bad_x < 0) row.first_bad_x = static_cast<int>(x);
        return;
    }
    row.max_component = std::max(row.max_component, max_component(pixel));
    if (pixel_class == PixelClass::zero) return;
    row.log_sum += std::log(double{pixel.y});
    row.min_positive = std::min(row.min_positive, pixel.y);
    row.max = std::max(row.max, pixel.y);
    if (sums.counted.has(x)) sums.histogram.add(pixel.y);
}

/// Those above 0, in whatever order the lanes are.
void count_positive(Vector luminances, LuminanceHistogram& histogram) noexcept {
    std::array<float, hn::MaxLanes(Floats())> values{};
    hn::StoreU(luminances, Floats(), values.data());
    for (std::size_t i = 0; i < hn::Lanes(Floats()); ++i) {
        if (values[i] > 0.0f) histogram.add(values[i]);
    }
}

/// Statistics of whole vectors of pixels whose luminances are 0 or normal numbers, and whose components are finite.
class VectorStatistics {
  public:
    VectorStatistics()
        : min_(hn::Set(Floats(), std::numeric_limits<float>::infinity())),
          max_(hn::Zero(Floats())),
          components_(hn::Zero(hn::RebindToSigned<Floats>())) {}

    /// The vectors from pixel x on, up to the first that has another pixel, or that would be past the end. Returns
    /// where that one begins.
    std::size_t add(std::size_t x, std::span<const XYZ> row, const RowSums& sums) {
        static_assert(CountedGroups::kPixels % hn::MaxLanes(Floats()) == 0);
        const Floats tag;
        const std::size_t lanes = hn::Lanes(tag);
        const PixelLanes pixel_lanes;
        const auto zero = hn::Zero(tag), one = hn::Set(tag, 1.0f);
        const auto infinite = magnitude(hn::Set(tag, std::numeric_limits<float>::infinity()));
        const auto least_normal = hn::Set(tag, std::numeric_limits<float>::min());
        for (; x + lanes <= row.size(); x += lanes) {
            const PixelVectors pixels(&row[x].x);
            const auto luminances = pixel_lanes.some_luminances(pixels);
            // As bits, which rise with magnitude: NaN is past infinity.
            const auto components = hn::Max(hn::Max(magnitude(pixels.a), magnitude(pixels.b)), magnitude(pixels.c));
            const auto is_finite = hn::RebindMask(tag, hn::Lt(components, infinite));
            const auto is_plain = hn::And(hn::Ge(luminances, least_normal), is_finite);
            if (HWY_UNLIKELY(!hn::AllTrue(tag, is_plain))) {
                const auto is_zero = hn::And(hn::Eq(luminances, zero), is_finite);
                if (!hn::AllTrue(tag, hn::Or(is_plain, is_zero))) break;
                if (sums.counted.has(x)) count_positive(luminances, sums.histogram);
                zeros_ += static_cast<std::int64_t>(hn::CountTrue(tag, is_zero));
                min_ = hn::Min(min_, hn::IfThenElse(is_zero, min_, luminances));
                max_ = hn::Max(max_, luminances);
                log_sum_.add(hn::IfThenElse(is_zero, one, luminances));
            } else {
                if (sums.counted.has(x)) count_positive(luminances, sums.histogram);
                min_ = hn::Min(min_, luminances);
                max_ = hn::Max(max_, luminances);
                log_sum_.add(luminances);
            }
            components_ = hn::Max(components_, components);
            pixels_ += static_cast<std::int64_t>(lanes);
        }
        return x;
    }

    void add_to(RowStatistics& row) {
        row.min_positive = std::min(row.min_positive, hn::GetLane(hn::MinOfLanes(Floats(), min_)));
        row.max = std::max(row.max, hn::GetLane(hn::MaxOfLanes(Floats(), max_)));
        const auto components = hn::BitCast(Floats(), components_);
        row.max_component = std::max(row.max_component, hn::GetLane(hn::MaxOfLanes(Floats(), components)));
        row.counts.positive += pixels_ - zeros_;
        row.counts.zero += zeros_;
        row.log_sum += log_sum_.sum();
    }

  private:
    std::int64_t pixels_ = 0, zeros_ = 0;
    using Bits = hn::Vec<hn::RebindToSigned<Floats>>;
    [[nodiscard]] static Bits magnitude(Vector values) noexcept {
        return hn::BitCast(hn::RebindToSigned<Floats>(), hn::Abs(values));
    }

    Vector min_, max_;
    Bits components_;  ///< largest magnitudes, as bits
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
