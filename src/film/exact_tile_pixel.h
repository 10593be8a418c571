#pragma once
// The exact sums of one pixel of a tile, made to be added to at every sample.
//
// A term v is split without error: `high` is the nearest multiple of 2^-9 (ties to even), and `low` the rest, rounded
// to the nearest multiple of the film's resolution. Each is a whole number of units in the lowest bits of a double that
// has a constant added to it, so that sums of those bits are sums of 64-bit integers: two additions, two subtractions
// and two integer additions, for two channels at a time. The sum of both is what ExactSum(v) would be.

#include <array>
#include <cstdint>

#include "film/exact_sum.h"
#include "film/weighted_sums.h"

namespace emulsion {

class ExactTilePixel {
  public:
    /// So many calls of add() may come between two of carry().
    static constexpr std::uint32_t kAddsPerCarry = 1u << 28;

    /// Adds weight * XYZ and the weight, each rounded once, to the nearest multiple of ExactSum's and ExactWeightSum's
    /// resolution; the sums are exact. If a number is NaN or infinite it does nothing and returns false.
    bool add(double x, double y, double z, double weight) noexcept {
        const Two xy = {weight * x, weight * y}, zw = {weight * z, weight};
        const Two size = magnitude(xy) + magnitude(zw);
        if (!(size[0] + size[1] < kQuickLimit)) [[unlikely]]
            return add_large({xy[0], xy[1], zw[0], zw[1]});
        const Parts first = split(xy, Two{kXyzRest, kXyzRest}), second = split(zw, Two{kXyzRest, kWeightRest});
        high_xy_ += first.high;
        high_zw_ += second.high;
        low_xy_ += first.low;
        low_zw_ += second.low;
        return true;
    }

    /// Moves what the low parts have gathered into the high ones; the sums stay what they are.
    void carry() noexcept;

    // In units of ExactSum's resolution, and of ExactWeightSum's; perhaps beyond their ranges.
    [[nodiscard]] Int128 x_units() const noexcept { return units<ExactSum>(high_xy_[0], low_xy_[0]); }
    [[nodiscard]] Int128 y_units() const noexcept { return units<ExactSum>(high_xy_[1], low_xy_[1]); }
    [[nodiscard]] Int128 z_units() const noexcept { return units<ExactSum>(high_zw_[0], low_zw_[0]); }
    [[nodiscard]] Int128 weight_units() const noexcept { return units<ExactWeightSum>(high_zw_[1], low_zw_[1]); }
    [[nodiscard]] WeightedSums sums() const noexcept {
        return {{value<ExactSum>(x_units()), value<ExactSum>(y_units()), value<ExactSum>(z_units())},
                value<ExactWeightSum>(weight_units())};
    }

  private:
    using Two [[gnu::vector_size(16)]] = double;
    using Ints [[gnu::vector_size(16)]] = std::int64_t;
    struct Parts {
        Ints high, low;  // in units of 2^-9, and of the resolution
    };

    // Doubles in [2^n, 2^(n + 1)) are multiples of 2^(n - 52); 1.5 * 2^n leaves room for 2^(n - 1) on both sides.
    static constexpr int kHighFractionBits = 9;
    static constexpr double kTop = 0x1.8p43;         // 52 - kHighFractionBits
    static constexpr double kXyzRest = 0x1.8p8;      // 52 - ExactSum::kFractionBits
    static constexpr double kWeightRest = 0x1.8p22;  // 52 - ExactWeightSum::kFractionBits
    static_assert(ExactSum::kFractionBits == 52 - 8 && ExactWeightSum::kFractionBits == 52 - 22);
    // Larger terms are added one by one. kAddsPerCarry high parts of quick terms add up to no more than 2^61 units, and
    // as many low parts, of up to 2^34 units each, to no more than 2^62: neither leaves 64 bits, from a high part of
    // up to 2^62 + 2^61 and a low one of up to 2^35.
    static constexpr double kQuickLimit = 0x1p24;

    [[nodiscard]] static Ints bits(Two numbers) noexcept { return reinterpret_cast<Ints>(numbers); }
    [[nodiscard]] static Two magnitude(Two numbers) noexcept {
        constexpr std::int64_t kAllButSign = INT64_MAX;
        return reinterpret_cast<Two>(bits(numbers) & Ints{kAllButSign, kAllButSign});
    }
    [[nodiscard]] static Parts split(Two terms, Two rest) noexcept {
        constexpr Two kTops = {kTop, kTop};
        const Two top = terms + kTops;
        const Two low = (terms - (top - kTops)) + rest;
        return {bits(top) - bits(kTops), bits(low) - bits(rest)};
    }

    template <class Sum>
    [[nodiscard]] static Int128 units(std::int64_t high, std::int64_t low) noexcept {
        return (static_cast<Int128>(high) << (Sum::kFractionBits - kHighFractionBits)) + low;
    }
    template <class Sum>
    [[nodiscard]] static double value(Int128 units) noexcept {
        return Sum::from_units(units).value();
    }

    /// The same as add() for terms of any size.
    bool add_large(const std::array<double, 4>& terms) noexcept;

    /// Calls visit(high, low, channel, ExactSum{} or ExactWeightSum{}) for the four sums, which it may change.
    template <class Visit>
    void for_each_channel(const Visit& visit) noexcept;

    Ints high_xy_{}, high_zw_{}, low_xy_{}, low_zw_{};
};

}  // namespace emulsion
