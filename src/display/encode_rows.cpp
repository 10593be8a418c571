#include "display/encode_rows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/encode_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "display/curve_vectors.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Values by vectors of toe(x) and of the table above it, a block of them at a time, and what is left over by the curve
/// itself.
template <class Curve, class Toe>
HWY_INLINE void replace(const Curve& curve, std::span<float> values, const Toe& toe) {
    constexpr std::size_t kBlock = 64;
    const CurveFloats tag;
    const std::size_t lanes = hn::Lanes(tag), whole = values.size() / lanes * lanes;
    const auto last = hn::Set(tag, curve.last);
    alignas(64) std::array<std::uint32_t, kBlock> offsets{};
    for (std::size_t begin = 0; begin < whole; begin += kBlock) {
        float* const block = &values[begin];
        const std::size_t count = std::min(kBlock, whole - begin);
        for (std::size_t i = 0; i < count; i += lanes) {
            hn::Store(segment_offsets(curve.above, hn::LoadU(tag, block + i)), CurveOffsets(), &offsets[i]);
        }
        for (std::size_t i = 0; i < count; i += lanes) {
            const auto x = hn::LoadU(tag, block + i);
            hn::StoreU(hn::IfThenElse(hn::Le(x, last), toe(x), value_at(curve.above, &offsets[i], x)), tag, block + i);
        }
    }
    for (float& value : values.subspan(whole)) value = curve(value);
}

void straight_toe(const StraightToeCurve& curve, std::span<float> values) {
    const auto slope = hn::Set(CurveFloats(), curve.slope), offset = hn::Set(CurveFloats(), curve.offset);
    replace(curve, values, [&](CurveVector x) { return hn::Add(offset, hn::Mul(slope, x)); });
}

void square_root_toe(const SquareRootToeCurve& curve, std::span<float> values) {
    const auto three = hn::Set(CurveFloats(), 3.0f);
    replace(curve, values, [&](CurveVector x) { return hn::Sqrt(hn::Mul(three, x)); });
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {

HWY_EXPORT(straight_toe);
HWY_EXPORT(square_root_toe);

}  // namespace

void encode_row(const StraightToeCurve& curve, std::span<float> values) noexcept {
    HWY_DYNAMIC_DISPATCH(straight_toe)(curve, values);
}

void encode_row(const SquareRootToeCurve& curve, std::span<float> values) noexcept {
    HWY_DYNAMIC_DISPATCH(square_root_toe)(curve, values);
}

}  // namespace emulsion
#endif
