// CurveTable for vectors of arguments: for rows of numbers.
// Compiled once for each instruction set: included by sources that hwy/foreach_target.h includes again.

#include <array>
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

/// Of every four segments at these offsets, in bytes, number `which`; those of the upper four in the upper half.
template <std::size_t Lanes>
HWY_INLINE CurveVector load_segments(const CurveTable::Segment* segments,
                                     const std::array<std::uint32_t, Lanes>& offsets, std::size_t which) {
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

/// The bits of what CurveTable gives. Segments are fetched whole and transposed.
HWY_INLINE CurveVector lookup(const CurveTable& table, CurveVector x) {
    namespace hn = hwy::HWY_NAMESPACE;
    const CurveFloats tag;
    const hn::RebindToUnsigned<CurveFloats> unsigned_tag;
    const hn::RebindToSigned<CurveFloats> signed_tag;
    const hn::Repartition<double, CurveFloats> pair_tag;
    const auto bits = hn::BitCast(unsigned_tag, x);
    // In bytes: the number of the segment times its size.
    static_assert(sizeof(CurveTable::Segment) == 16);
    constexpr int kShift = CurveTable::kFractionBits - 4;
    const auto number = hn::And(hn::ShiftRight<kShift>(bits), hn::Set(unsigned_tag, ~std::uint32_t{15}));
    const auto offset =
        hn::Min(hn::Sub(number, hn::Set(unsigned_tag, 16 * table.first())), hn::Set(unsigned_tag, 16 * table.last()));
    const auto fraction = hn::BitCast(signed_tag, hn::And(bits, hn::Set(unsigned_tag, CurveTable::kFractionMask)));
    const auto t = hn::Mul(hn::ConvertTo(tag, fraction), hn::Set(tag, CurveTable::kPerSegment));

    alignas(32) std::array<std::uint32_t, hn::MaxLanes(CurveFloats())> offsets;  // NOLINT: written at once
    hn::Store(offset, unsigned_tag, offsets.data());
    const auto s0 = load_segments(table.segments(), offsets, 0), s1 = load_segments(table.segments(), offsets, 1);
    const auto s2 = load_segments(table.segments(), offsets, 2), s3 = load_segments(table.segments(), offsets, 3);
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
