#pragma once
// Sums that do not depend on the order of their terms: fixed-point numbers of 64, 96 or 128 bits.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace emulsion {

__extension__ typedef __int128 Int128;            // NOLINT(modernize-use-using): __extension__ takes no alias
__extension__ typedef unsigned __int128 UInt128;  // NOLINT(modernize-use-using)

/// A multiple of 2^-FractionBits in (-kLimit, kLimit). Addition is that of integers: associative and commutative,
/// without rounding. In memory a two's complement number of `Bits` bits, in words of 32, the lowest first.
///
/// A sum that leaves the range stops at its end and stays there, whatever is added: is_saturated(). Order matters only
/// to sums that saturate.
template <int Bits, int FractionBits>
class FixedPointSum {
    static_assert(Bits == 64 || Bits == 96 || Bits == 128);
    static_assert(std::endian::native == std::endian::little, "the words are copied as they lie in memory");

  public:
    static constexpr int kFractionBits = FractionBits;
    static constexpr double kResolution = 1.0 / static_cast<double>(Int128{1} << FractionBits);
    static constexpr double kLimit = static_cast<double>(Int128{1} << (Bits - 2)) * 2.0 * kResolution;

    constexpr FixedPointSum() = default;

    /// The nearest multiple of kResolution (ties to even). Saturated if |value| >= kLimit, and high if it is NaN.
    explicit FixedPointSum(double value) noexcept {
        if (std::abs(value) < kQuickLimit) {
            *this = from_quick(value);
        } else if (std::abs(value) < kLimit) {
            *this = from_units(static_cast<Int128>(std::nearbyint(value * kUnitsPerOne)));
        } else {
            store(value < 0.0 ? -kHighest : kHighest);
        }
    }

    /// units * kResolution, saturated if it is beyond the range.
    [[nodiscard]] static FixedPointSum from_units(Int128 units) noexcept {
        FixedPointSum sum;
        sum.store(clamped(units));
        return sum;
    }

    FixedPointSum& operator+=(const FixedPointSum& other) noexcept { return add_units(other.units()); }

    /// Adds units * kResolution.
    FixedPointSum& add_units(Int128 more) noexcept {
        const Int128 sum = units();
        if (is_small(sum) && is_small(more)) [[likely]] {
            store(sum + more);
        } else {
            store(saturating_sum(sum, more));
        }
        return *this;
    }

    /// The nearest double.
    [[nodiscard]] double value() const noexcept { return static_cast<double>(units()) * kResolution; }
    [[nodiscard]] bool is_saturated() const noexcept { return is_end(units()); }
    bool operator==(const FixedPointSum&) const = default;

  private:
    /// Two 64-bit conversions, where one to 128 bits would be a call: the multiple of 2^kShift units nearest to the
    /// value, and the rest. Both are exact but for the rounding to units.
    [[nodiscard]] static FixedPointSum from_quick(double value) noexcept {
        const double units = value * kUnitsPerOne, top = (units + kSplit) - kSplit;
        const auto high = static_cast<std::int64_t>(top * kPerShift);
        const auto low = static_cast<std::int64_t>(std::nearbyint(units - top));
        FixedPointSum sum;
        sum.store((Int128{high} << kShift) + low);
        return sum;
    }

    static constexpr int kShift = 32;
    static constexpr double kPerShift = 1.0 / static_cast<double>(std::int64_t{1} << kShift);
    static constexpr double kSplit = 1.5 * static_cast<double>(Int128{1} << (52 + kShift));
    // Tops are below 2^51 units of the split's, and sums within a quarter of the range.
    static constexpr double kQuickLimit = static_cast<double>(Int128{1} << std::min(Bits - 3, 50 + kShift)) *
                                          (1.0 / static_cast<double>(Int128{1} << FractionBits));
    static constexpr std::size_t kBytes = Bits / 8;
    static constexpr double kUnitsPerOne = static_cast<double>(Int128{1} << FractionBits);
    // -kHighest - 1 is never stored, so that both ends are alike.
    static constexpr Int128 kHighest = ((Int128{1} << (Bits - 2)) - 1) * 2 + 1;

    [[nodiscard]] static bool is_end(Int128 units) noexcept { return units == kHighest || units == -kHighest; }

    /// Within a quarter of the range: two such numbers add up to one of the range.
    [[nodiscard]] static bool is_small(Int128 units) noexcept {
        constexpr int kSmallBits = Bits - 3;
        return ((static_cast<UInt128>(units) + (UInt128{1} << kSmallBits)) >> (kSmallBits + 1)) == 0;
    }
    [[nodiscard]] static Int128 clamped(Int128 units) noexcept {
        return units > kHighest ? kHighest : (units < -kHighest ? -kHighest : units);
    }
    [[nodiscard]] static Int128 saturating_sum(Int128 a, Int128 b) noexcept {
        if (is_end(a)) return a;
        Int128 sum = 0;
        const bool overflows = __builtin_add_overflow(a, clamped(b), &sum);
        if (overflows || is_end(clamped(b))) return b < 0 ? -kHighest : kHighest;
        return clamped(sum);
    }

    [[nodiscard]] Int128 units() const noexcept {
        std::uint64_t low = 0;
        std::memcpy(&low, words_.data(), sizeof(low));
        if constexpr (Bits == 64) {
            return static_cast<std::int64_t>(low);
        } else {
            std::conditional_t<Bits == 96, std::int32_t, std::int64_t> high = 0;
            std::memcpy(&high, words_.data() + 2, sizeof(high));
            return (static_cast<Int128>(high) << 64) | low;
        }
    }
    void store(Int128 units) noexcept { std::memcpy(words_.data(), &units, kBytes); }

    std::array<std::uint32_t, Bits / 32> words_{};
};

/// For sums of weight * X, Y or Z, Y in cd/m^2: multiples of 2^-44 = 5.7e-14 in (-2^51, 2^51) = 2.25e15, in 12 bytes.
/// The darkest night sky, 1e-6 cd/m^2, enters with an error of at most 2.9e-8 of itself, half of that of a `float`; a
/// constant picture is right to 1e-6 of itself down to 2.9e-8 cd/m^2. At the other end, 2^51 is the sum of 1.4 million
/// samples of the sun's disc (1.6e9 cd/m^2), of 2^24 samples of 1.3e8 cd/m^2, or of 2^32 of 5.2e5 cd/m^2.
using ExactSum = FixedPointSum<96, 44>;

/// For sums of weights, of mean 1: multiples of 2^-30 = 9.3e-10 in (-2^33, 2^33), twice the most samples of a pixel.
/// Floats of at least 2^-7 enter exactly.
using ExactWeightSum = FixedPointSum<64, 30>;

static_assert(sizeof(ExactSum) == 12 && sizeof(ExactWeightSum) == 8);

}  // namespace emulsion
