#pragma once
// Pseudo-random numbers that depend only on their seed: never on threads, time or place.

#include <bit>
#include <cstdint>

namespace emulsion {

/// Mixes the bits of x so that each output bit depends on all input bits.
/// Source: Steele, Lea & Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014 (variant 13 of Stafford).
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t x) noexcept {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// Folds one more value into a hash. The value is mixed before it meets the hash, so that neighbouring hashes and
/// values (seed 0 at pixel 1, seed 1 at pixel 0) don't meet in the same result.
[[nodiscard]] constexpr std::uint64_t hash_combine(std::uint64_t hash, std::uint64_t value) noexcept {
    return mix_bits(hash ^ mix_bits(value + 0x9e3779b97f4a7c15u));
}

/// A float in [0, 1) on a grid of 2^-24, from the top bits of x: every float of that grid is equally likely.
[[nodiscard]] constexpr float unit_float(std::uint32_t x) noexcept { return static_cast<float>(x >> 8) * 0x1p-24f; }

/// A double in [0, 1) on a grid of 2^-53.
[[nodiscard]] constexpr double unit_double(std::uint64_t x) noexcept { return static_cast<double>(x >> 11) * 0x1p-53; }

/// PCG32 (XSH-RR): 64-bit state, 32-bit output, 2^63 streams.
/// Source: O'Neill, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms", 2014.
class Pcg32 {
  public:
    explicit constexpr Pcg32(std::uint64_t seed = 0, std::uint64_t stream = 0) noexcept
        : increment_((stream << 1u) | 1u) {
        next();
        state_ += mix_bits(seed);
        next();
    }

    constexpr std::uint32_t next() noexcept {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment_;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
        return std::rotr(shifted, static_cast<int>(old >> 59u));
    }

    /// Uniform in [0, 1).
    constexpr float next_float() noexcept { return unit_float(next()); }

  private:
    std::uint64_t state_ = 0, increment_;
};

}  // namespace emulsion
