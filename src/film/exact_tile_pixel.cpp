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
    const std::uint64_t count = low_zc_[1] & ((std::uint64_t{1} << 52) - 1);
    const auto number = [&](std::uint64_t sum, double constant) {
        return static_cast<std::int64_t>(sum - count * std::bit_cast<std::uint64_t>(constant));
    };
    return {{number(high_xy_[0], kTop), number(high_xy_[1], kTop), number(high_zw_[0], kTop)},
            {number(low_xy_[0], kRest), number(low_xy_[1], kRest), number(low_zc_[0], kRest)},
            number(high_zw_[1], kWeightTop)};
}

void ExactTilePixel::store(const Plain& plain) noexcept {
    const auto word = [](std::int64_t number) { return static_cast<std::uint64_t>(number); };
    high_xy_ = Uint2{word(plain.high[0]), word(plain.high[1])};
    high_zw_ = Uint2{word(plain.high[2]), word(plain.weight)};
    low_xy_ = Uint2{word(plain.low[0]), word(plain.low[1])};
    low_zc_ = Uint2{word(plain.low[2]), 0};
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
    store(sums);
    return true;
}

void ExactTilePixel::add_block(ExactTilePixel* first, std::ptrdiff_t stride, std::span<const float> x_weights,
                               std::span<const float> y_weights, const XYZd& xyz) noexcept {
#ifdef __x86_64__
    static const bool kHasAvx2 = __builtin_cpu_supports("avx2") != 0;
    if (kHasAvx2) return add_block_avx2(first, stride, x_weights, y_weights, xyz);
#endif
    for (const float y_weight : y_weights) {
        ExactTilePixel* pixel = first;
        for (const float x_weight : x_weights) {
            (pixel++)->add(xyz.x, xyz.y, xyz.z, static_cast<double>(x_weight * y_weight));
        }
        first += stride;
    }
}

#ifdef __x86_64__

[[gnu::target("avx2")]] void ExactTilePixel::add_block_avx2(ExactTilePixel* first, std::ptrdiff_t stride,
                                                            std::span<const float> x_weights,
                                                            std::span<const float> y_weights,
                                                            const XYZd& xyz) noexcept {
    static_assert(sizeof(ExactTilePixel) == 64, "high parts and low parts lie side by side");
    const __m256d value = _mm256_setr_pd(xyz.x, xyz.y, xyz.z, 1.0);
    const __m256d top = _mm256_setr_pd(kTop, kTop, kTop, kWeightTop);
    const __m256d top_and_rest = _mm256_setr_pd(kTop + kRest, kTop + kRest, kTop + kRest, kWeightTop + kOne);
    const auto least = [](double of) { return static_cast<std::int64_t>(std::uint64_t{least_upper(of)} << 32); };
    const __m256i least_bits = _mm256_setr_epi64x(least(kTop), least(kTop), least(kTop), least(kWeightTop));
    const __m256i beyond = _mm256_set1_epi64x(~((std::int64_t{2} << kQuickUnitsBits) - 1));
    for (const float y_weight : y_weights) {
        ExactTilePixel* pixel = first;
        for (const float x_weight : x_weights) {
            const __m256d terms = _mm256_mul_pd(_mm256_set1_pd(static_cast<double>(x_weight * y_weight)), value);
            const __m256d high = _mm256_add_pd(terms, top);
            const __m256i high_bits = _mm256_castpd_si256(high);
            if (_mm256_testz_si256(_mm256_sub_epi64(high_bits, least_bits), beyond) == 0) [[unlikely]] {
                pixel->add_large({terms[0], terms[1], terms[2], terms[3]});
            } else {
                const __m256i low_bits = _mm256_castpd_si256(_mm256_add_pd(_mm256_sub_pd(top_and_rest, high), terms));
                auto* const highs = reinterpret_cast<__m256i*>(&pixel->high_xy_);
                auto* const lows = reinterpret_cast<__m256i*>(&pixel->low_xy_);
                _mm256_storeu_si256(highs, _mm256_add_epi64(_mm256_loadu_si256(highs), high_bits));
                _mm256_storeu_si256(lows, _mm256_add_epi64(_mm256_loadu_si256(lows), low_bits));
            }
            ++pixel;
        }
        first += stride;
    }
}

#endif

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
