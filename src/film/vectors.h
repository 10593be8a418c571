#pragma once
// Numbers in one 16-byte vector register: GCC's vector types, and what they have no operators for.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#ifdef __SSE4_1__
#include <smmintrin.h>
#endif

namespace emulsion {

using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;
using Uint4 [[gnu::vector_size(16)]] = std::uint32_t;
using Double2 [[gnu::vector_size(16)]] = double;
using Uint2 [[gnu::vector_size(16)]] = std::uint64_t;

/// Four times number I of a vector.
template <int I>
[[nodiscard]] inline Float4 broadcast(Float4 numbers) noexcept {
    // By way of integers: of those, the processor shuffles a copy in one instruction.
    const auto bits = std::bit_cast<Int4>(numbers);
    return std::bit_cast<Float4>(__builtin_shufflevector(bits, bits, I, I, I, I));
}

/// The smaller of each pair.
[[nodiscard]] inline Uint4 smaller(Uint4 a, Uint4 b) noexcept {
#ifdef __SSE4_1__
    return std::bit_cast<Uint4>(_mm_min_epu32(std::bit_cast<__m128i>(a), std::bit_cast<__m128i>(b)));
#else
    return a < b ? a : b;
#endif
}

/// Whether a comparison is true in all four places.
[[nodiscard]] inline bool all(Int4 comparison) noexcept {
#ifdef __SSE4_1__
    return _mm_movemask_ps(std::bit_cast<__m128>(comparison)) == 0b1111;
#else
    const auto pairs = std::bit_cast<Uint2>(comparison);
    return (pairs[0] & pairs[1]) == ~std::uint64_t{0};
#endif
}

/// Whether no number has a bit that `mask` has.
[[nodiscard]] inline bool are_disjoint(Uint4 numbers, Uint4 mask) noexcept {
#ifdef __SSE4_1__
    return _mm_testz_si128(std::bit_cast<__m128i>(numbers), std::bit_cast<__m128i>(mask)) != 0;
#else
    const auto common = std::bit_cast<Uint2>(numbers & mask);
    return (common[0] | common[1]) == 0;
#endif
}

/// The four numbers as scalars. For indices: by two 64-bit moves, quicker than by memory or one by one.
[[nodiscard]] inline std::array<std::uint32_t, 4> scalars(Uint4 numbers) noexcept {
    const auto pairs = std::bit_cast<Uint2>(numbers);
    const std::uint64_t first = pairs[0], second = pairs[1];
    if constexpr (std::endian::native == std::endian::little) {
        return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(first >> 32),
                static_cast<std::uint32_t>(second), static_cast<std::uint32_t>(second >> 32)};
    }
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace emulsion
