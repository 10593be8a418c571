#include "tonemap/neighbourhood_rows.h"

#include <array>
#include <cstddef>
#include <limits>

#include "core/color.h"

// Compiled once for each instruction set; which of them runs is decided when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tonemap/neighbourhood_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/vector_loop.h"

HWY_BEFORE_NAMESPACE();
namespace emulsion::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

bool relative(const float* in, float per_unit, float least_outlier, float most, float* out, std::size_t count) {
    bool any_missing = false;
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        const auto largest = hn::Set(tag, std::numeric_limits<float>::max());
        auto x = hn::Zero(tag), y = x, z = x;
        hn::LoadInterleaved3(tag, in + 3 * i, x, y, z);
        const auto within = hn::And(hn::Ge(y, hn::Zero(tag)), hn::Lt(y, hn::Set(tag, least_outlier)));
        const auto finite =
            hn::And(hn::Le(y, largest), hn::And(hn::Le(hn::Abs(x), largest), hn::Le(hn::Abs(z), largest)));
        const auto is_good = hn::And(within, finite);
        const auto relative = hn::Min(hn::Mul(y, hn::Set(tag, per_unit)), hn::Set(tag, most));
        hn::StoreU(hn::IfThenElse(is_good, relative, hn::Set(tag, -1.0f)), tag, out + i);
        any_missing = any_missing || !hn::AllTrue(tag, is_good);
    });
    return any_missing;
}

struct Weights {
    const float* kernel;
    std::size_t radius;
    const float* const* taps;
};

/// Several vectors of sums at a time, from `begin` on: enough for additions not to wait for one another.
template <std::size_t Vectors, class Tag>
HWY_INLINE void convolve_block(Tag tag, const Weights& weights, std::size_t begin, float* out) {
    using Vector = hn::Vec<Tag>;
    const std::size_t lanes = hn::Lanes(tag);
    const float* const middle = weights.taps[weights.radius] + begin;
    auto weight = hn::Set(tag, weights.kernel[0]);
    std::array<Vector, Vectors> sum;  // NOLINT(cppcoreguidelines-pro-type-member-init): registers
    for (std::size_t i = 0; i < Vectors; ++i) sum[i] = hn::Mul(weight, hn::LoadU(tag, middle + lanes * i));
    for (std::size_t j = 1; j <= weights.radius; ++j) {
        const float* const before = weights.taps[weights.radius - j] + begin;
        const float* const after = weights.taps[weights.radius + j] + begin;
        weight = hn::Set(tag, weights.kernel[j]);
        for (std::size_t i = 0; i < Vectors; ++i) {
            const auto pair = hn::Add(hn::LoadU(tag, before + lanes * i), hn::LoadU(tag, after + lanes * i));
            sum[i] = hn::Add(sum[i], hn::Mul(weight, pair));
        }
    }
    for (std::size_t i = 0; i < Vectors; ++i) hn::StoreU(sum[i], tag, out + begin + lanes * i);
}

void convolve_rows(const float* kernel, std::size_t radius, const float* const* taps, float* out, std::size_t count) {
    constexpr std::size_t kVectors = 4;
    const Weights weights{kernel, radius, taps};
    const std::size_t lanes = hn::Lanes(Floats());
    std::size_t begin = 0;
    for (; begin + kVectors * lanes <= count; begin += kVectors * lanes) {
        convolve_block<kVectors>(Floats(), weights, begin, out);
    }
    for (; begin + lanes <= count; begin += lanes) convolve_block<1>(Floats(), weights, begin, out);
    for (; begin < count; ++begin) convolve_block<1>(OneFloat(), weights, begin, out);
}

void add_weighted(const float* weights, const float* const* rows, std::size_t number, float* out, std::size_t count) {
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        auto sum = hn::Mul(hn::Set(tag, weights[0]), hn::LoadU(tag, rows[0] + i));
        for (std::size_t k = 1; k < number; ++k) {
            sum = hn::Add(sum, hn::Mul(hn::Set(tag, weights[k]), hn::LoadU(tag, rows[k] + i)));
        }
        hn::StoreU(sum, tag, out + i);
    });
}

void halve(const float* in, float* half, std::size_t count) {
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        auto before = hn::Zero(tag), even = before, odd = before, after = before;
        hn::LoadInterleaved2(tag, in + 2 * i - 1, before, even);
        hn::LoadInterleaved2(tag, in + 2 * i + 1, odd, after);
        const auto inner = hn::Mul(hn::Set(tag, 3.0f), hn::Add(even, odd));
        hn::StoreU(hn::Mul(hn::Set(tag, 0.125f), hn::Add(hn::Add(before, after), inner)), tag, half + i);
    });
}

void double_up(const float* in, float* out, std::size_t count) {
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        const auto quarter = hn::Set(tag, 0.25f);
        const auto nearer = hn::Mul(hn::Set(tag, 0.75f), hn::LoadU(tag, in + i));
        const auto left = hn::Add(nearer, hn::Mul(quarter, hn::LoadU(tag, in + i - 1)));
        const auto right = hn::Add(nearer, hn::Mul(quarter, hn::LoadU(tag, in + i + 1)));
        hn::StoreInterleaved2(left, right, tag, out + 2 * i);
    });
}

/// What comes of a scale, from what comes of accepting it.
template <class Tag, class Vector = hn::Vec<Tag>>
HWY_INLINE Vector decide(Tag tag, const ScaleRows& scale, std::size_t i, Vector accepted) {
    const auto before = hn::LoadU(tag, scale.before + i), centre = hn::LoadU(tag, scale.centre + i);
    const auto difference = hn::Abs(hn::Sub(centre, hn::LoadU(tag, scale.surround + i)));
    const auto scaling = hn::Mul(hn::Set(tag, scale.limit), hn::Add(hn::Set(tag, scale.floor), centre));
    const auto left = hn::Sub(hn::Set(tag, 1.5f), hn::Div(difference, scaling)), one = hn::Set(tag, 1.0f);
    const auto acceptance = hn::Min(hn::Max(left, hn::Zero(tag)), one);
    return hn::Add(hn::Mul(acceptance, accepted), hn::Mul(hn::Sub(one, acceptance), before));
}

void decide_all(const ScaleRows* scales, std::size_t number, float* row, std::size_t count) {
    for_each_vector(count, [&](auto tag, std::size_t i) HWY_ATTR {
        auto chosen = hn::LoadU(tag, row + i);
        for (std::size_t scale = 0; scale < number; ++scale) chosen = decide(tag, scales[scale], i, chosen);
        hn::StoreU(chosen, tag, row + i);
    });
}

}  // namespace emulsion::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace emulsion {

namespace {

HWY_EXPORT(relative);
HWY_EXPORT(convolve_rows);
HWY_EXPORT(add_weighted);
HWY_EXPORT(halve);
HWY_EXPORT(double_up);
HWY_EXPORT(decide_all);

}  // namespace

bool relative_row(std::span<const XYZ> in, float per_unit, float least_outlier, float most, std::span<float> out) {
    static_assert(sizeof(XYZ) == 3 * sizeof(float));
    return HWY_DYNAMIC_DISPATCH(relative)(&in.data()->x, per_unit, least_outlier, most, out.data(), out.size());
}

void convolve(std::span<const float> kernel, std::span<const float* const> taps, std::span<float> out) {
    HWY_DYNAMIC_DISPATCH(convolve_rows)(kernel.data(), kernel.size() - 1, taps.data(), out.data(), out.size());
}

void add_rows(std::span<const float> weights, std::span<const float* const> rows, std::span<float> out) {
    HWY_DYNAMIC_DISPATCH(add_weighted)(weights.data(), rows.data(), rows.size(), out.data(), out.size());
}

void halve_row(const float* in, std::span<float> half) { HWY_DYNAMIC_DISPATCH(halve)(in, half.data(), half.size()); }

void double_row(const float* in, std::span<float> out) {
    HWY_DYNAMIC_DISPATCH(double_up)(in, out.data(), out.size() / 2);
}

void decide_row(std::span<const ScaleRows> scales, std::span<float> row) {
    HWY_DYNAMIC_DISPATCH(decide_all)(scales.data(), scales.size(), row.data(), row.size());
}

}  // namespace emulsion
#endif
