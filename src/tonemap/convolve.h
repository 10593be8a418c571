#pragma once
// The inner loop of every blur.

#include <span>

namespace emulsion {

/// out[i] = the sum of kernel[|j|] taps[r + j][i] over all j in [-r, r]: kernel has r + 1 weights, the same before and
/// behind the middle, taps 2 r + 1 arrays. Every sum is taken in the same order, with the same bits wherever it is.
void convolve(std::span<const float> kernel, std::span<const float* const> taps, std::span<float> out) noexcept;

}  // namespace emulsion
