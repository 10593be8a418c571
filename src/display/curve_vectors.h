// CurveTable for vectors of arguments: for rows of numbers.
// Compiled once for each instruction set: included by sources that hwy/foreach_target.h includes again.

#include <cstddef>
#include <cstdint>

#include <hwy/highway.h>

#include "display/curve_table.h"

// Highway's idiom in the place of `#pragma once`.
#if defined(EMULSION_DISPLAY_CURVE_VECTORS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef EMULSION_DISPLAY_CURVE_VECTORS_H
#undef EMULSION_DISPLAY_CURVE_VECTORS_H
#else
#define EMULSION_DISPLAY_CURVE_VECTORS_H
#endif

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

/// Up to eight at a time: segments are fetched one by one, and wider vectors would save nothing.
using CurveFloats = hwy::HWY_NAMESPACE::CappedTag<float, 8>;
using CurveVector = hwy::HWY_NAMESPACE::Vec<CurveFloats>;

using CurveOffsets = hwy::HWY_NAMESPACE::RebindToUnsigned<CurveFloats>;

/// Where the segment of each argument begins, in bytes: its number times its size. To be stored, and read one by one,
/// which is quicker than to take them out of a vector.
HWY_INLINE hwy::HWY_NAMESPACE::Vec<CurveOffsets> segment_offsets(const CurveTable& table, CurveVector x) {
    namespace hn = hwy::HWY_NAMESPACE;
    static_assert(sizeof(CurveTable::Segment) == 16);
    constexpr int kShift = CurveTable::kFractionBits - 4;
    const CurveOffsets tag;
    const auto number = hn::And(hn::ShiftRight<kShift>(hn::BitCast(tag, x)), hn::Set(tag, ~std::uint32_t{15}));
    return hn::Min(hn::Sub(number, hn::Set(tag, 16 * table.first())), hn::Set(tag, 16 * table.last()));
}

/// Of every four segments at these offsets number `which`; those of the upper four in the upper half.
template <std::size_t Lanes>
HWY_INLINE CurveVector load_segments(const CurveTable::Segment* segments, const std::uint32_t* offsets,
                                     std::size_t which) {
    namespace hn = hwy::HWY_NAMESPACE;
    const hn::FixedTag<float, 4> four;
    const auto segment = [&](std::size_t i) {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): to let the processor add what vectors reckoned
        return hn::Load(four, reinterpret_cast<const float*>(reinterpret_cast<const char*>(segments) + offsets[i]));
    };
    const auto lower = segment(which);
    if constexpr (Lanes == 8) {
        return hn::Combine(CurveFloats(), segment(which + 4), lower);
    } else {
        static_assert(Lanes == 4);
        return lower;
    }
}

/// The bits of what CurveTable gives, with the segment_offsets() of x. Segments are fetched whole and transposed.
HWY_INLINE CurveVector value_at(const CurveTable& table, const std::uint32_t* offsets, CurveVector x) {
    namespace hn = hwy::HWY_NAMESPACE;
    const CurveFloats tag;
    const hn::RebindToSigned<CurveFloats> signed_tag;
    const hn::Repartition<double, CurveFloats> pair_tag;
    const auto mask = hn::Set(signed_tag, static_cast<std::int32_t>(CurveTable::kFractionMask));
    const auto fraction = hn::ConvertTo(tag, hn::And(hn::BitCast(signed_tag, x), mask));
    const auto t = hn::Mul(fraction, hn::Set(tag, CurveTable::kPerSegment));

    constexpr std::size_t kLanes = hn::MaxLanes(tag);
    const auto segments = [&](std::size_t which) { return load_segments<kLanes>(table.segments(), offsets, which); };
    const auto s0 = segments(0), s1 = segments(1), s2 = segments(2), s3 = segments(3);
    const auto low01 = hn::BitCast(pair_tag, hn::InterleaveLower(tag, s0, s1));
    const auto low23 = hn::BitCast(pair_tag, hn::InterleaveLower(tag, s2, s3));
    const auto high01 = hn::BitCast(pair_tag, hn::InterleaveUpper(tag, s0, s1));
    const auto high23 = hn::BitCast(pair_tag, hn::InterleaveUpper(tag, s2, s3));
    const auto start = hn::BitCast(tag, hn::InterleaveLower(pair_tag, low01, low23));
    const auto linear = hn::BitCast(tag, hn::InterleaveUpper(pair_tag, low01, low23));
    const auto square = hn::BitCast(tag, hn::InterleaveLower(pair_tag, high01, high23));
    return hn::Add(start, hn::Mul(t, hn::Add(linear, hn::Mul(t, square))));
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
