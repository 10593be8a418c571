#include "display/gamut_rows.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/gamut_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/vector_loop.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// 0 for NaN.
template <class Tag>
HWY_INLINE hn::Vec<Tag> number(Tag /*tag*/, hn::Vec<Tag> v) {
    return hn::IfThenElseZero(hn::Eq(v, v), v);
}

/// Distance of a number from [0, 1].
template <class Tag>
HWY_INLINE hn::Vec<Tag> distance(Tag tag, hn::Vec<Tag> v) {
    return hn::Max(hn::Max(hn::Neg(v), hn::Sub(v, hn::Set(tag, 1.0f))), hn::Zero(tag));
}

template <class Tag>
HWY_INLINE hn::Vec<Tag> clipped(Tag tag, hn::Vec<Tag> v) {
    return hn::Min(hn::IfThenElseZero(hn::Gt(v, hn::Zero(tag)), v), hn::Set(tag, 1.0f));
}

/// Pixels in vectors by component, numbers all, and what of them is outside.
template <class Tag>
struct Measured {
    hn::Vec<Tag> r, g, b, excess;
    GamutCounts counts;
};

template <class Tag>
HWY_INLINE Measured<Tag> measured(Tag tag, const float* pixels) {
    auto r = hn::Zero(tag), g = r, b = r;
    hn::LoadInterleaved3(tag, pixels, r, g, b);
    // Each component by itself: sums of infinities would be NaN.
    const auto is_number = hn::And(hn::And(hn::Eq(r, r), hn::Eq(g, g)), hn::Eq(b, b));
    r = number(tag, r), g = number(tag, g), b = number(tag, b);
    const auto excess = hn::Max(hn::Max(distance(tag, r), distance(tag, g)), distance(tag, b));
    const auto is_outside = hn::And(is_number, hn::Gt(excess, hn::Set(tag, kGamutTolerance)));
    GamutCounts counts;
    counts.outside = static_cast<std::int64_t>(hn::CountTrue(tag, is_outside));
    counts.nan = static_cast<std::int64_t>(hn::Lanes(tag) - hn::CountTrue(tag, is_number));
    counts.largest_excess = hn::GetLane(hn::MaxOfLanes(tag, excess));
    return {r, g, b, excess, counts};
}

/// Whether all components of a vector of pixels are in [0, 1].
template <class Tag>
HWY_INLINE bool all_inside(Tag tag, const float* pixels) {
    const std::size_t lanes = hn::Lanes(tag);
    const auto zero = hn::Zero(tag), one = hn::Set(tag, 1.0f);
    const auto inside = [&](std::size_t which) {
        const auto v = hn::LoadU(tag, pixels + which * lanes);
        return hn::And(hn::Ge(v, zero), hn::Le(v, one));
    };
    return hn::AllTrue(tag, hn::And(hn::And(inside(0), inside(1)), inside(2)));
}

void clip(std::span<RGB> linear, GamutCounts& counts) {
    static_assert(sizeof(RGB) == 3 * sizeof(float));
    if (linear.empty()) return;
    float* const components = &linear.data()->r;
    for_each_pixel_vector(linear.size(), [&](auto tag, std::size_t i) {
        float* const pixels = components + 3 * i;
        if (all_inside(tag, pixels)) return;
        const auto found = measured(tag, pixels);
        counts += found.counts;
        hn::StoreInterleaved3(clipped(tag, found.r), clipped(tag, found.g), clipped(tag, found.b), tag, pixels);
    });
}

void measure(std::span<const RGB> linear, std::span<float> excess, GamutCounts& counts) {
    if (linear.empty()) return;
    const float* const components = &linear.data()->r;
    for_each_pixel_vector(linear.size(), [&](auto tag, std::size_t i) {
        const auto found = measured(tag, components + 3 * i);
        counts += found.counts;
        hn::StoreU(found.excess, tag, &excess[i]);
    });
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {

HWY_EXPORT(clip);
HWY_EXPORT(measure);

}  // namespace

GamutCounts clip_row(std::span<RGB> linear) noexcept {
    GamutCounts counts;
    HWY_DYNAMIC_DISPATCH(clip)(linear, counts);
    return counts;
}

GamutCounts measure_row(std::span<const RGB> linear, std::span<float> excess) noexcept {
    GamutCounts counts;
    HWY_DYNAMIC_DISPATCH(measure)(linear, excess, counts);
    return counts;
}

}  // namespace emulsion
#endif
