#pragma once
// Arithmetic on eight floats at a time, compiled twice: for the machine that the build is for, and for AVX2, which is
// chosen at run time.

#include <cstddef>

// An attribute of functions and lambdas: their code goes where they are called, and so is compiled for what the caller
// is.
#define EMULSION_INLINE __attribute__((always_inline))

namespace emulsion {

/// Eight floats: one register of AVX2, two of SSE. GCC and Clang have operators for it.
using Floats [[gnu::vector_size(32)]] = float;
inline constexpr std::size_t kLanes = 8;

/// The same anywhere in an array of floats. std::memcpy would go through smaller registers.
using FloatsInArray [[gnu::vector_size(32), gnu::aligned(4), gnu::may_alias]] = float;

EMULSION_INLINE inline void load(Floats& to, const float* from) noexcept {
    to = *reinterpret_cast<const FloatsInArray*>(from);
}
EMULSION_INLINE inline void store(float* to, const Floats& from) noexcept {
    *reinterpret_cast<FloatsInArray*>(to) = from;
}

#if defined(__x86_64__)
template <class Loop>
[[gnu::target("avx2")]] void run_with_avx2(const Loop& loop) noexcept {
    loop();
}
#endif

/// Calls loop(), a lambda that is EMULSION_INLINE, compiled for the widest vectors that the processor has. Without
/// contraction to fused multiply-adds, sums are taken in the same order with the same bits, so results are the same.
template <class Loop>
void with_wide_vectors(const Loop& loop) noexcept {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return run_with_avx2(loop);
#endif
    loop();
}

}  // namespace emulsion
