#pragma once
// The exact sums of one pixel of a tile, made to be added to at every sample.
//
// A term v is split without error: `high` is the nearest multiple of 2^-9 (ties to even), and `low` the rest, rounded
// to the nearest multiple of the film's resolution. Each is a whole number of units in the lowest bits of a double that
// has a constant added to it, so that sums of those bits are sums of 64-bit integers: three additions of doubles and
// two of integers, for two channels at a time. The sum of both is what ExactSum(v) would be.
//
// The bits of the constants are summed up as well, and taken off together, later. How many there are, one for each
// term, is counted in place of the low part of the weight, which needs none: it is rounded to ExactWeightSum's
// resolution at once.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/color.h"
#include "film/exact_sum.h"
#include "film/vectors.h"
#include "film/weighted_sums.h"

// add() is inlined into the renderer, and (a + b - c) + d is nothing but rounding to such compilers.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || __FINITE_MATH_ONLY__
#error "emulsion: exact sums need exact arithmetic; compile what includes the film without -ffast-math"
#endif

namespace emulsion {

class alignas(64) ExactTilePixel {  // a line of the cache
  public:
    /// So many calls of add() may come between two of carry().
    static constexpr std::uint32_t kAddsPerCarry = 1u << 24;

    /// Adds weight * XYZ and the weight, each rounded once, to the nearest multiple of ExactSum's and ExactWeightSum's
    /// resolution; the sums are exact. If a number is NaN or infinite it does nothing and returns false.
    bool add(double x, double y, double z, double weight) noexcept {
        const Double2 weights = {weight, weight}, xy = weights * Double2{x, y}, zw = weights * Double2{z, 1.0};
        const Double2 top_xy = xy + kTopXy, top_zw = zw + kTopZw;
        if (!are_quick(top_xy, top_zw)) [[unlikely]]
            return add_large({xy[0], xy[1], zw[0], zw[1]});
        high_xy_ += bits(top_xy);
        high_zw_ += bits(top_zw);
        low_xy_ += bits((kTopXy + kRestXy - top_xy) + xy);
        low_zc_ += bits((kTopZw + kRestZc - top_zw) + zw);
        return true;
    }

    /// add(x, y, z, x_weights[i] * y_weights[j]) to pixel i of row j, for all weights. Rows are `stride` pixels apart;
    /// XYZ and weights must be finite.
    static void add_block(ExactTilePixel* first, std::ptrdiff_t stride, std::span<const float> x_weights,
                          std::span<const float> y_weights, const XYZd& xyz) noexcept;

    /// The same for 4 x 4 pixels, all in registers. The fourth number of `xyz` is anything finite.
    static void add_four_by_four(ExactTilePixel* first, std::ptrdiff_t stride, Float4 x_weights, Float4 y_weights,
                                 Float4 xyz) noexcept;

    /// Moves what the low parts have gathered into the high ones; the sums stay what they are.
    void carry() noexcept;

    /// How many terms were added; up to 2^52.
    [[nodiscard]] std::uint64_t samples() const noexcept { return low_zc_[1] & kCountMask; }

    // In units of ExactSum's resolution, and of ExactWeightSum's; perhaps beyond their ranges.
    [[nodiscard]] Int128 x_units() const noexcept { return xyz_units(0); }
    [[nodiscard]] Int128 y_units() const noexcept { return xyz_units(1); }
    [[nodiscard]] Int128 z_units() const noexcept { return xyz_units(2); }
    [[nodiscard]] Int128 weight_units() const noexcept;
    [[nodiscard]] WeightedSums sums() const noexcept;

  private:
    // Doubles in [2^n, 2^(n + 1)) are multiples of 2^(n - 52); 1.5 * 2^n leaves room for 2^(n - 1) on both sides.
    static constexpr int kHighFractionBits = 9;
    static constexpr double kTop = 0x1.8p43;        // 52 - kHighFractionBits
    static constexpr double kRest = 0x1.8p8;        // 52 - ExactSum::kFractionBits
    static constexpr double kWeightTop = 0x1.8p22;  // 52 - ExactWeightSum::kFractionBits
    static_assert(ExactSum::kFractionBits == 52 - 8 && ExactWeightSum::kFractionBits == 52 - 22);
    // Its bits are 1 above a multiple of 2^52: their sum counts. A unit in its last place is 256, so that any quick
    // weight, 64 and -64 among them, is less than half of one and lost in it.
    static constexpr double kOne = 0x1.0000000000001p60;
    static constexpr std::uint64_t kCountMask = (std::uint64_t{1} << 52) - 1;

    static constexpr Double2 kTopXy = {kTop, kTop}, kTopZw = {kTop, kWeightTop};
    static constexpr Double2 kRestXy = {kRest, kRest}, kRestZc = {kRest, kOne};

    // Larger terms, from 2^27 and weights from 64 on, are added one by one. In kAddsPerCarry quick terms, of up to 2^36
    // units of the high part each, those add up to no more than 2^60 units, and the low parts, of up to 2^34 units
    // each, to no more than 2^58: neither leaves 64 bits, from a high part of up to 2^62 + 2^61 and a low one of 2^35.
    static constexpr int kQuickUnitsBits = 36;

    [[nodiscard]] static Uint2 bits(Double2 numbers) noexcept { return std::bit_cast<Uint2>(numbers); }

    /// The upper half of the double that `top` and the least quick high part add up to.
    [[nodiscard]] static constexpr std::uint32_t least_upper(double top) noexcept {
        return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(top) >> 32) - (1u << (kQuickUnitsBits - 32));
    }
    /// Whether all high parts are in [-2^kQuickUnitsBits, 2^kQuickUnitsBits), by the upper halves of those doubles;
    /// not so for NaN and infinities.
    [[nodiscard]] static bool are_quick(Double2 top_xy, Double2 top_zw) noexcept {
        constexpr Uint4 kLeast = {least_upper(kTop), least_upper(kTop), least_upper(kTop), least_upper(kWeightTop)};
        constexpr std::uint32_t kBeyond = ~((2u << (kQuickUnitsBits - 32)) - 1u);
        const Uint4 upper =
            __builtin_shufflevector(std::bit_cast<Uint4>(top_xy), std::bit_cast<Uint4>(top_zw), 1, 3, 5, 7);
        return are_disjoint(upper - kLeast, Uint4{kBeyond, kBeyond, kBeyond, kBeyond});
    }

    struct Plain;
    struct Avx2;
    /// The sums without the constants' bits.
    [[nodiscard]] Plain plain() const noexcept;
    void store(const Plain& plain) noexcept;
    [[nodiscard]] Int128 xyz_units(std::size_t channel) const noexcept;
    /// add_block() one by one.
    static void add_any_block(ExactTilePixel* first, std::ptrdiff_t stride, std::span<const float> x_weights,
                              std::span<const float> y_weights, const XYZd& xyz) noexcept;

    /// The same as add() for terms of any size.
    bool add_large(const std::array<double, 4>& terms) noexcept;

    // By channel: x and y, z and the weight; of the low parts, z and the count of terms.
    Uint2 high_xy_{}, high_zw_{}, low_xy_{}, low_zc_{};
};

}  // namespace emulsion
