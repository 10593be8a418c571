#include "tonemap/convolve.h"

#include <cstddef>

#include "tonemap/wide_vectors.h"

namespace emulsion {

namespace {

/// Explicit, as GCC does not keep arrays of floats in registers here.
constexpr std::size_t kRegisters = 4;

struct Weights {
    const float* kernel;
    std::size_t radius;
    const float* const* taps;
};

EMULSION_INLINE inline void convolve_block(const Weights& weights, std::size_t begin, float* out) noexcept {
    const float* const middle = weights.taps[weights.radius] + begin;
    Floats sum[kRegisters];  // NOLINT(modernize-avoid-c-arrays): registers, not an object
    for (std::size_t i = 0; i < kRegisters; ++i) {
        load(sum[i], middle + kLanes * i);
        sum[i] *= weights.kernel[0];
    }
    for (std::size_t j = 1; j <= weights.radius; ++j) {
        const float* const before = weights.taps[weights.radius - j] + begin;
        const float* const after = weights.taps[weights.radius + j] + begin;
        for (std::size_t i = 0; i < kRegisters; ++i) {
            Floats a, b;
            load(a, before + kLanes * i);
            load(b, after + kLanes * i);
            sum[i] += weights.kernel[j] * (a + b);
        }
    }
    for (std::size_t i = 0; i < kRegisters; ++i) store(out + begin + kLanes * i, sum[i]);
}

EMULSION_INLINE inline void convolve_one(const Weights& weights, std::size_t at, float* out) noexcept {
    float sum = weights.kernel[0] * weights.taps[weights.radius][at];
    for (std::size_t j = 1; j <= weights.radius; ++j) {
        sum += weights.kernel[j] * (weights.taps[weights.radius - j][at] + weights.taps[weights.radius + j][at]);
    }
    out[at] = sum;
}

}  // namespace

void convolve(std::span<const float> kernel, std::span<const float* const> taps, std::span<float> out) noexcept {
    const Weights weights{kernel.data(), kernel.size() - 1, taps.data()};
    float* const sums = out.data();
    with_wide_vectors([=, count = out.size()]() EMULSION_INLINE {
        std::size_t begin = 0;
        for (; begin + kRegisters * kLanes <= count; begin += kRegisters * kLanes) convolve_block(weights, begin, sums);
        for (; begin < count; ++begin) convolve_one(weights, begin, sums);
    });
}

}  // namespace emulsion
