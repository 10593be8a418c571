#pragma once
// Well-spread points: the first two dimensions of Sobol's sequence, Owen-scrambled, and random permutations by hashing.
// All are pure functions of an index and a seed.

#include <array>
#include <bit>
#include <cstdint>

#include "core/random.h"

namespace emulsion {

/// The bits of x in reverse order: van der Corput's sequence in base 2, as 32-bit fractions.
[[nodiscard, gnu::always_inline]] constexpr std::uint32_t reverse_bits(std::uint32_t x) noexcept {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
    return std::rotl(x, 16);
}

/// Point `index` of the second dimension of Sobol's sequence, as a 32-bit fraction. Its generator matrix is Pascal's
/// triangle modulo 2, a tensor power of (1 1; 0 1), and so the product takes one step for each bit of a bit's place.
/// Source: Ahmed, "An Implementation Algorithm of 2D Sobol Sequence Fast, Elegant, and Compact", EGSR 2024.
[[nodiscard]] constexpr std::uint32_t sobol_second(std::uint32_t index) noexcept {
    std::uint32_t x = reverse_bits(index);
    x ^= (x & 0x55555555u) << 1;
    x ^= (x & 0x33333333u) << 2;
    x ^= (x & 0x0f0f0f0fu) << 4;
    x ^= (x & 0x00ff00ffu) << 8;
    return x ^ (x << 16);
}

/// Owen's nested uniform scrambling, by hashing: each bit is flipped depending on all higher bits and the seed.
/// Source: Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; the multipliers are Vegdahl's (2021).
[[nodiscard, gnu::always_inline]] constexpr std::uint32_t owen_scramble(std::uint32_t x, std::uint32_t seed) noexcept {
    x = reverse_bits(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverse_bits(x);
}

/// Point `index` of a two-dimensional Sobol' sequence, shuffled and scrambled by `seed`: each power of two of
/// consecutive indices that starts at a multiple of itself is a (0, 2)-net. Both in [0, 1).
[[nodiscard]] constexpr std::array<float, 2> scrambled_sobol_2d(std::uint32_t index, std::uint64_t seed) noexcept {
    const std::uint64_t first = mix_bits(seed), second = mix_bits(first + 1);
    const std::uint32_t shuffled = owen_scramble(index, static_cast<std::uint32_t>(first >> 32));
    return {unit_float(owen_scramble(reverse_bits(shuffled), static_cast<std::uint32_t>(first))),
            unit_float(owen_scramble(sobol_second(shuffled), static_cast<std::uint32_t>(second)))};
}

/// The same in one dimension.
[[nodiscard]] constexpr float scrambled_sobol_1d(std::uint32_t index, std::uint64_t seed) noexcept {
    const std::uint64_t hash = mix_bits(seed);
    const std::uint32_t shuffled = owen_scramble(index, static_cast<std::uint32_t>(hash >> 32));
    return unit_float(owen_scramble(reverse_bits(shuffled), static_cast<std::uint32_t>(hash)));
}

/// Where `index` in [0, count) goes under a permutation of [0, count) that the seed picks.
/// Source: cycle walking on a hash of the next power of two; Kensler, "Correlated Multi-Jittered Sampling", Pixar 2013.
[[nodiscard]] constexpr std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint32_t seed) noexcept {
    const std::uint32_t mask = std::bit_ceil(count) - 1;
    const int shift = (std::bit_width(mask) + 1) / 2;
    do {
        // Each step is a bijection of [0, mask]: adding, multiplying by odd numbers, xor with a right shift.
        index = (index + seed) & mask;
        index = (index * 0x2c1b3c6du) & mask;
        index ^= index >> shift;
        index = (index * ((seed >> 8) | 1u)) & mask;
        index ^= index >> shift;
        index = (index * 0x297a2d39u + (seed >> 16)) & mask;
        index ^= index >> shift;
    } while (index >= count);
    return index;
}

}  // namespace emulsion
