#include "display/code_rows.h"

#include <cstddef>

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/code_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "display/code_units.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// As many values as doubles fill a vector, or one.
template <class DoubleTag>
struct ValueTags {
    DoubleTag doubles;
    hn::Rebind<float, DoubleTag> floats;
    hn::Rebind<std::int32_t, DoubleTag> ints;
    hn::Rebind<std::uint16_t, DoubleTag> codes;
};

/// Calls step(tags, i) for vectors of [0, count), and for what is left over value by value.
template <class Step>
HWY_INLINE void for_each_value(std::size_t count, const Step& step) {
    const ValueTags<hn::ScalableTag<double>> many{};
    const ValueTags<hn::CappedTag<double, 1>> one{};
    std::size_t i = 0;
    for (; i + hn::Lanes(many.doubles) <= count; i += hn::Lanes(many.doubles)) step(many, i);
    for (; i < count; ++i) step(one, i);
}

/// As CodeUnits has it, of a number of them at once: encoded values times `white`, to the nearest, halves up.
template <class Tags>
HWY_INLINE auto whole_numbers(const Tags& tags, const float* encoded, double white) {
    const auto values = hn::LoadU(tags.floats, encoded);
    const auto positive = hn::IfThenElseZero(hn::Gt(values, hn::Zero(tags.floats)), values);
    const auto unit = hn::PromoteTo(tags.doubles, hn::Min(positive, hn::Set(tags.floats, 1.0f)));
    const auto scaled = hn::Mul(unit, hn::Set(tags.doubles, white));
    return hn::DemoteTo(tags.ints, hn::Add(scaled, hn::Set(tags.doubles, 0.5)));
}

/// Thresholds in units.
template <class Tags>
HWY_INLINE auto in_units(const Tags& tags, const Threshold* thresholds, int unused_bits) {
    return hn::ShiftRightSame(hn::PromoteTo(tags.ints, hn::LoadU(tags.codes, thresholds)), unused_bits);
}

/// Whole numbers above the code of black as codes.
template <class Tags, class Ints>
HWY_INLINE void store_codes(const Tags& tags, Ints steps, const CodeScale& scale, std::uint16_t* codes) {
    const auto all = hn::Add(steps, hn::Set(tags.ints, scale.black));
    hn::StoreU(hn::DemoteTo(tags.codes, all), tags.codes, codes);
}

void nearest(std::span<const float> encoded, const CodeScale& scale, std::span<std::uint16_t> codes) {
    const double steps = scale.steps();
    for_each_value(codes.size(), [&](auto tags, std::size_t i) {
        store_codes(tags, whole_numbers(tags, &encoded[i], steps), scale, &codes[i]);
    });
}

void thresholded(std::span<const float> encoded, std::span<const Threshold> thresholds, const CodeScale& scale,
                 std::span<std::uint16_t> codes) {
    const CodeUnits units(scale);
    const int fraction_bits = units.fraction_bits(), unused_bits = 16 - fraction_bits;
    const double white = units.white();
    for_each_value(codes.size(), [&](auto tags, std::size_t i) {
        const auto values = whole_numbers(tags, &encoded[i], white);
        const auto sums = hn::Add(values, in_units(tags, &thresholds[i], unused_bits));
        store_codes(tags, hn::ShiftRightSame(sums, fraction_bits), scale, &codes[i]);
    });
}

void with_triangular_noise(std::span<const float> encoded, std::span<const Threshold> first,
                           std::span<const Threshold> second, const CodeScale& scale, std::span<std::uint16_t> codes) {
    const CodeUnits units(scale);
    const int fraction_bits = units.fraction_bits(), unused_bits = 16 - fraction_bits;
    const double white = units.white();
    const std::int32_t half = units.per_code() / 2, near_white = units.white() - half;
    for_each_value(codes.size(), [&](auto tags, std::size_t i) {
        const auto values = whole_numbers(tags, &encoded[i], white);
        const auto rectangular = in_units(tags, &first[i], unused_bits);
        const auto both = hn::Add(rectangular, in_units(tags, &second[i], unused_bits));
        const auto triangular = hn::Add(both, hn::Set(tags.ints, 1 - half));
        const auto near_end =
            hn::Or(hn::Lt(values, hn::Set(tags.ints, half)), hn::Gt(values, hn::Set(tags.ints, near_white)));
        const auto sums = hn::Add(values, hn::IfThenElse(near_end, rectangular, triangular));
        store_codes(tags, hn::ShiftRightSame(sums, fraction_bits), scale, &codes[i]);
    });
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {

HWY_EXPORT(nearest);
HWY_EXPORT(thresholded);
HWY_EXPORT(with_triangular_noise);

}  // namespace

void round_to_nearest(std::span<const float> encoded, const CodeScale& scale, std::span<std::uint16_t> codes) noexcept {
    HWY_DYNAMIC_DISPATCH(nearest)(encoded, scale, codes);
}

void round_by_thresholds(std::span<const float> encoded, std::span<const Threshold> thresholds, const CodeScale& scale,
                         std::span<std::uint16_t> codes) noexcept {
    HWY_DYNAMIC_DISPATCH(thresholded)(encoded, thresholds, scale, codes);
}

void round_with_triangular_noise(std::span<const float> encoded, std::span<const Threshold> first,
                                 std::span<const Threshold> second, const CodeScale& scale,
                                 std::span<std::uint16_t> codes) noexcept {
    HWY_DYNAMIC_DISPATCH(with_triangular_noise)(encoded, first, second, scale, codes);
}

}  // namespace emulsion
#endif
