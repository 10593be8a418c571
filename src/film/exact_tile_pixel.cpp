#include "film/exact_tile_pixel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace emulsion {

namespace {

/// Beyond are sums that have left every range; they are kept well within, so that quick terms don't bring them back.
/// For weights that is from 2^32 on, twice the most samples of a tile's pixel.
constexpr std::int64_t kEnd = std::int64_t{1} << 62;
constexpr std::int64_t kSaturated = kEnd + kEnd / 2;

bool is_saturated(std::int64_t high) noexcept { return high >= kEnd || high <= -kEnd; }

std::int64_t saturated(double sign) noexcept { return sign < 0.0 ? -kSaturated : kSaturated; }

}  // namespace

struct ExactTilePixel::Plain {
    static constexpr int kShift = ExactSum::kFractionBits - kHighFractionBits;
    static constexpr std::int64_t kLowMask = (std::int64_t{1} << kShift) - 1;

    std::array<std::int64_t, 3> high{}, low{};
    std::int64_t weight = 0;
    std::uint64_t count = 0;

    void carry() noexcept {
        for (std::size_t i = 0; i < 3; ++i) {
            high[i] = is_saturated(high[i]) ? saturated(static_cast<double>(high[i])) : high[i] + (low[i] >> kShift);
            low[i] = is_saturated(high[i]) ? 0 : low[i] & kLowMask;
        }
        if (is_saturated(weight)) weight = saturated(static_cast<double>(weight));
    }

    void add_xyz(std::size_t i, double term) noexcept {
        if (is_saturated(high[i])) return;
        if (std::abs(term) >= ExactSum::kLimit) {
            high[i] = saturated(term);
            return;
        }
        const auto units = static_cast<Int128>(std::nearbyint(std::ldexp(term, ExactSum::kFractionBits)));
        high[i] += static_cast<std::int64_t>(units >> kShift);
        low[i] += static_cast<std::int64_t>(units) & kLowMask;
    }

    void add_weight(double term) noexcept {
        if (is_saturated(weight)) return;
        const double units = std::nearbyint(std::ldexp(term, ExactWeightSum::kFractionBits));
        const double sum = static_cast<double>(weight) + units;
        weight = std::abs(sum) < static_cast<double>(kEnd) ? weight + static_cast<std::int64_t>(units) : saturated(sum);
    }
};

ExactTilePixel::Plain ExactTilePixel::plain() const noexcept {
    const std::uint64_t count = samples();
    const auto number = [&](std::uint64_t sum, double constant) {
        return static_cast<std::int64_t>(sum - count * std::bit_cast<std::uint64_t>(constant));
    };
    return {{number(high_xy_[0], kTop), number(high_xy_[1], kTop), number(high_zw_[0], kTop)},
            {number(low_xy_[0], kRest), number(low_xy_[1], kRest), number(low_zc_[0], kRest)},
            number(high_zw_[1], kWeightTop),
            count};
}

void ExactTilePixel::store(const Plain& plain) noexcept {
    const auto sum = [&](std::int64_t number, double constant) {
        return static_cast<std::uint64_t>(number) + plain.count * std::bit_cast<std::uint64_t>(constant);
    };
    high_xy_ = Uint2{sum(plain.high[0], kTop), sum(plain.high[1], kTop)};
    high_zw_ = Uint2{sum(plain.high[2], kTop), sum(plain.weight, kWeightTop)};
    low_xy_ = Uint2{sum(plain.low[0], kRest), sum(plain.low[1], kRest)};
    low_zc_ = Uint2{sum(plain.low[2], kRest), sum(0, kOne)};
}

void ExactTilePixel::carry() noexcept {
    Plain sums = plain();
    sums.carry();
    store(sums);
}

bool ExactTilePixel::add_large(const std::array<double, 4>& terms) noexcept {
    if (!std::all_of(terms.begin(), terms.end(), [](double term) { return std::isfinite(term); })) return false;
    Plain sums = plain();
    for (std::size_t i = 0; i < 3; ++i) sums.add_xyz(i, terms[i]);
    sums.add_weight(terms[3]);
    ++sums.count;
    store(sums);
    return true;
}

#ifdef __x86_64__

/// X, Y, Z and the weight in one register, for blocks of quick terms. The same bits.
struct ExactTilePixel::Avx2 {
    // All terms are quick if their three factors are smaller than these.
    static constexpr float kQuickWeight = 8.0f;
    static constexpr double kQuickValue = 0x1p21;
    static_assert(kQuickValue * kQuickWeight * kQuickWeight == 0x1p27 && kHighFractionBits + 27 == kQuickUnitsBits);
    static_assert(kQuickWeight * kQuickWeight == 0x1p6 && ExactWeightSum::kFractionBits + 6 == kQuickUnitsBits);

    static bool are_quick(std::span<const float> weights) noexcept {
        const __m128 sign = _mm_set1_ps(-0.0f), limit = _mm_set1_ps(kQuickWeight);
        __m128 beyond = _mm_setzero_ps();
        const float* weight = weights.data();
        for (std::size_t fours = weights.size() / 4; fours > 0; --fours, weight += 4) {
            beyond = _mm_or_ps(beyond, _mm_cmpge_ps(_mm_andnot_ps(sign, _mm_loadu_ps(weight)), limit));
        }
        for (std::size_t rest = weights.size() % 4; rest > 0; --rest, ++weight) {
            beyond = _mm_or_ps(beyond, _mm_cmpge_ps(_mm_andnot_ps(sign, _mm_load_ss(weight)), limit));
        }
        return _mm_movemask_ps(beyond) == 0;
    }
    static bool are_quick(const XYZd& xyz) noexcept {
        return std::max({std::abs(xyz.x), std::abs(xyz.y), std::abs(xyz.z)}) < kQuickValue;
    }

    static bool are_quick(Float4 x_weights, Float4 y_weights, Float4 xyz) noexcept {
        const auto size = [](Float4 numbers) {
            return _mm_andnot_ps(_mm_set1_ps(-0.0f), std::bit_cast<__m128>(numbers));
        };
        const __m128 weights = _mm_cmplt_ps(_mm_max_ps(size(x_weights), size(y_weights)), _mm_set1_ps(kQuickWeight));
        const __m128 values = _mm_cmplt_ps(size(xyz), _mm_set1_ps(static_cast<float>(kQuickValue)));
        return _mm_movemask_ps(_mm_and_ps(weights, values)) == 15;
    }

    [[gnu::target("avx2")]] static __m256d four(double xyz, double weight) noexcept {
        return _mm256_setr_pd(xyz, xyz, xyz, weight);
    }

    [[gnu::target("avx2")]] static void add(ExactTilePixel& pixel, __m256d terms) noexcept {
        static_assert(sizeof(ExactTilePixel) == 64, "high parts and low parts lie side by side");
        const __m256d high = _mm256_add_pd(terms, four(kTop, kWeightTop));
        const __m256d low = _mm256_add_pd(_mm256_sub_pd(four(kTop + kRest, kWeightTop + kOne), high), terms);
        auto* const highs = reinterpret_cast<__m256i*>(&pixel.high_xy_);
        auto* const lows = reinterpret_cast<__m256i*>(&pixel.low_xy_);
        _mm256_store_si256(highs, _mm256_add_epi64(_mm256_load_si256(highs), _mm256_castpd_si256(high)));
        _mm256_store_si256(lows, _mm256_add_epi64(_mm256_load_si256(lows), _mm256_castpd_si256(low)));
    }

    /// To pixel[0] ... pixel[3].
    [[gnu::target("avx2")]] static void add_quick_four(ExactTilePixel* pixel, Float4 pixel_weights,
                                                       __m256d value) noexcept {
        const __m256d weights = _mm256_cvtps_pd(std::bit_cast<__m128>(pixel_weights));
        add(pixel[0], _mm256_mul_pd(_mm256_permute4x64_pd(weights, 0x00), value));
        add(pixel[1], _mm256_mul_pd(_mm256_permute4x64_pd(weights, 0x55), value));
        add(pixel[2], _mm256_mul_pd(_mm256_permute4x64_pd(weights, 0xaa), value));
        add(pixel[3], _mm256_mul_pd(_mm256_permute4x64_pd(weights, 0xff), value));
    }

    [[gnu::target("avx2")]] static void add_quick_block(ExactTilePixel* first, std::ptrdiff_t stride,
                                                        std::span<const float> x_weights,
                                                        std::span<const float> y_weights, const XYZd& xyz) noexcept {
        const __m256d value = _mm256_setr_pd(xyz.x, xyz.y, xyz.z, 1.0);
        const float* const x_end = x_weights.data() + x_weights.size();
        for (const float y_weight : y_weights) {
            ExactTilePixel* pixel = first;
            const float* x = x_weights.data();
            for (; x_end - x >= 4; x += 4, pixel += 4) {
                add_quick_four(pixel, std::bit_cast<Float4>(_mm_mul_ps(_mm_loadu_ps(x), _mm_set1_ps(y_weight))), value);
            }
            for (; x != x_end; ++x, ++pixel) {
                add(*pixel, _mm256_mul_pd(_mm256_set1_pd(static_cast<double>(*x * y_weight)), value));
            }
            first += stride;
        }
    }

    [[gnu::target("avx2")]] static void add_quick_four_by_four(ExactTilePixel* first, std::ptrdiff_t stride,
                                                               Float4 x_weights, Float4 y_weights,
                                                               Float4 xyz) noexcept {
        const __m256d value = _mm256_blend_pd(_mm256_cvtps_pd(std::bit_cast<__m128>(xyz)), _mm256_set1_pd(1.0), 0b1000);
        add_quick_four(first, x_weights * broadcast<0>(y_weights), value);
        add_quick_four(first + stride, x_weights * broadcast<1>(y_weights), value);
        add_quick_four(first + 2 * stride, x_weights * broadcast<2>(y_weights), value);
        add_quick_four(first + 3 * stride, x_weights * broadcast<3>(y_weights), value);
    }
};

#endif

void ExactTilePixel::add_four_by_four(ExactTilePixel* first, std::ptrdiff_t stride, Float4 x_weights, Float4 y_weights,
                                      Float4 xyz) noexcept {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") != 0 && Avx2::are_quick(x_weights, y_weights, xyz)) [[likely]] {
        return Avx2::add_quick_four_by_four(first, stride, x_weights, y_weights, xyz);
    }
#endif
    const auto x = std::bit_cast<std::array<float, 4>>(x_weights), y = std::bit_cast<std::array<float, 4>>(y_weights);
    add_any_block(first, stride, x, y,
                  {static_cast<double>(xyz[0]), static_cast<double>(xyz[1]), static_cast<double>(xyz[2])});
}

void ExactTilePixel::add_block(ExactTilePixel* first, std::ptrdiff_t stride, std::span<const float> x_weights,
                               std::span<const float> y_weights, const XYZd& xyz) noexcept {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") != 0 && Avx2::are_quick(xyz) && Avx2::are_quick(x_weights) &&
        Avx2::are_quick(y_weights)) [[likely]] {
        return Avx2::add_quick_block(first, stride, x_weights, y_weights, xyz);
    }
#endif
    add_any_block(first, stride, x_weights, y_weights, xyz);
}

void ExactTilePixel::add_any_block(ExactTilePixel* first, std::ptrdiff_t stride, std::span<const float> x_weights,
                                   std::span<const float> y_weights, const XYZd& xyz) noexcept {
    for (const float y_weight : y_weights) {
        ExactTilePixel* pixel = first;
        for (const float x_weight : x_weights) {
            (pixel++)->add(xyz.x, xyz.y, xyz.z, static_cast<double>(x_weight * y_weight));
        }
        first += stride;
    }
}

Int128 ExactTilePixel::xyz_units(std::size_t channel) const noexcept {
    const Plain sums = plain();
    return (static_cast<Int128>(sums.high[channel]) << Plain::kShift) + sums.low[channel];
}

Int128 ExactTilePixel::weight_units() const noexcept {
    const std::int64_t weight = plain().weight;
    // What is saturated here has to be so anywhere.
    return is_saturated(weight) ? Int128{weight} << 2 : Int128{weight};
}

WeightedSums ExactTilePixel::sums() const noexcept {
    const auto value = [](Int128 units) { return ExactSum::from_units(units).value(); };
    return {{value(x_units()), value(y_units()), value(z_units())}, ExactWeightSum::from_units(weight_units()).value()};
}

}  // namespace emulsion
