#pragma once
// CurveTable four arguments at a time: for rows of numbers.

#include <cstddef>
#include <cstdint>
#include <span>

#include <hwy/highway.h>

#include "core/color.h"
#include "display/curve_table.h"

namespace emulsion {

namespace hn = hwy::HWY_NAMESPACE;

/// Vectors of four, whatever the processor has: wider ones would have to gather, which costs more than it saves.
using Four = hn::FixedTag<float, 4>;
using FourFloats = hn::Vec<Four>;

/// The bits of what CurveTable gives. Segments are fetched whole and transposed.
[[nodiscard]] inline FourFloats lookup(const CurveTable& table, FourFloats x) noexcept {
    const Four tag;
    const hn::RebindToUnsigned<Four> unsigned_tag;
    const hn::RebindToSigned<Four> signed_tag;
    const hn::Repartition<double, Four> pair_tag;
    const auto bits = hn::BitCast(unsigned_tag, x);
    const auto index =
        hn::Min(hn::Sub(hn::ShiftRight<CurveTable::kFractionBits>(bits), hn::Set(unsigned_tag, table.first())),
                hn::Set(unsigned_tag, table.last()));
    const auto fraction = hn::BitCast(signed_tag, hn::And(bits, hn::Set(unsigned_tag, CurveTable::kFractionMask)));
    const auto t = hn::Mul(hn::ConvertTo(tag, fraction), hn::Set(tag, CurveTable::kPerSegment));

    const CurveTable::Segment* const segments = table.segments();
    const auto segment = [&](std::uint32_t i) { return hn::Load(tag, &segments[i].start); };
    const auto s0 = segment(hn::ExtractLane(index, 0)), s1 = segment(hn::ExtractLane(index, 1));
    const auto s2 = segment(hn::ExtractLane(index, 2)), s3 = segment(hn::ExtractLane(index, 3));
    const auto low01 = hn::BitCast(pair_tag, hn::InterleaveLower(tag, s0, s1));
    const auto low23 = hn::BitCast(pair_tag, hn::InterleaveLower(tag, s2, s3));
    const auto high01 = hn::BitCast(pair_tag, hn::InterleaveUpper(tag, s0, s1));
    const auto high23 = hn::BitCast(pair_tag, hn::InterleaveUpper(tag, s2, s3));
    const auto start = hn::BitCast(tag, hn::InterleaveLower(pair_tag, low01, low23));
    const auto linear = hn::BitCast(tag, hn::InterleaveUpper(pair_tag, low01, low23));
    const auto square = hn::BitCast(tag, hn::InterleaveLower(pair_tag, high01, high23));
    return hn::Add(start, hn::Mul(t, hn::Add(linear, hn::Mul(t, square))));
}

/// Replaces each component: by vectors(four of them) and, of those left over at the end, by single(component), which
/// has to give the same bits.
template <class Vectors, class Single>
void replace_components(std::span<RGB> pixels, const Vectors& vectors, const Single& single) noexcept {
    const Four tag;
    const std::size_t whole = pixels.size() / 4 * 4;
    for (std::size_t i = 0; i < whole; i += 4) {
        float* const components = &pixels[i].r;  // of four pixels: three vectors
        hn::StoreU(vectors(hn::LoadU(tag, components)), tag, components);
        hn::StoreU(vectors(hn::LoadU(tag, components + 4)), tag, components + 4);
        hn::StoreU(vectors(hn::LoadU(tag, components + 8)), tag, components + 8);
    }
    for (RGB& rgb : pixels.subspan(whole)) rgb = {single(rgb.r), single(rgb.g), single(rgb.b)};
}

}  // namespace emulsion
