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

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::ScalableTag<float>;
using Vector = hn::Vec<Floats>;

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

void add_pixel(const XYZ& pixel, std::size_t x, RowStatistics& row) noexcept {
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
}

RowStatistics gather(const XYZ* pixels, std::size_t size) {
    const Floats tag;
    const std::size_t lanes = hn::Lanes(tag);
    const auto largest = hn::Set(tag, std::numeric_limits<float>::max());
    const auto least_normal = hn::Set(tag, std::numeric_limits<float>::min());
    const auto infinity = hn::Set(tag, std::numeric_limits<float>::infinity());
    RowStatistics row;
    LogSum log_sum;
    auto min = infinity, max = hn::Zero(tag);
    std::size_t x = 0;
    for (; x + lanes <= size; x += lanes) {
        Vector px, py, pz;
        hn::LoadInterleaved3(tag, &pixels[x].x, px, py, pz);
        const auto is_normal = hn::And(hn::Ge(py, least_normal), hn::Le(py, largest));
        const auto is_zero = hn::Eq(py, hn::Zero(tag));
        const auto others_finite = hn::And(hn::Le(hn::Abs(px), largest), hn::Le(hn::Abs(pz), largest));
        if (HWY_UNLIKELY(!hn::AllTrue(tag, hn::And(hn::Or(is_normal, is_zero), others_finite)))) {
            for (std::size_t i = x; i < x + lanes; ++i) add_pixel(pixels[i], i, row);
            continue;
        }
        const auto positive = static_cast<std::int64_t>(hn::CountTrue(tag, is_normal));
        row.counts.positive += positive;
        row.counts.zero += static_cast<std::int64_t>(lanes) - positive;
        max = hn::Max(max, py);
        min = hn::Min(min, hn::IfThenElse(is_zero, infinity, py));
        log_sum.add(hn::IfThenElse(is_zero, hn::Set(tag, 1.0f), py));
    }
    row.min_positive = std::min(row.min_positive, hn::GetLane(hn::MinOfLanes(tag, min)));
    row.max = std::max(row.max, hn::GetLane(hn::MaxOfLanes(tag, max)));
    for (; x < size; ++x) add_pixel(pixels[x], x, row);
    row.log_sum += log_sum.sum();
    return row;
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {
HWY_EXPORT(gather);
}

RowStatistics statistics_of_row(std::span<const XYZ> row) noexcept {
    return HWY_DYNAMIC_DISPATCH(gather)(row.data(), row.size());
}

}  // namespace emulsion
#endif
