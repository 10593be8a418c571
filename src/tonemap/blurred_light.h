#pragma once
// Gaussian blurs of a few pixels, by direct sums along rows and columns, the picture being mirrored at its edges. For
// lobes of a kernel (scatter.h), of which twins take the values at pixel centres: so do the weights here, and add just
// their variance to what the pyramid has blurred already. Those of gaussian_kernel.h and gaussian_rows.h, for means
// over neighbourhoods, are integrated over pixels, which adds 1/12 px^2, as centre-surround needs them to sum to 1; and
// they keep one channel blurred in several ways apart, where here several channels are added up.

#include <span>
#include <vector>

#include "tonemap/light_rows.h"

namespace emulsion {

/// Weights of a Gaussian at offsets 0, 1, ..., up to four standard deviations; those of both signs add up to 1.
[[nodiscard]] std::vector<float> gaussian_weights(double variance_px2);

/// Blurs along x and along y by such weights.
struct GaussianBlur {
    std::vector<float> x, y;
    float share = 1.0f;  ///< what the result is multiplied by
};

/// Adds rows [y0, y1) of the picture blurred in each of the ways to `sum`, which has them one behind the other.
void add_blurred(const LightRows& light, std::span<const GaussianBlur> blurs, int y0, int y1, std::span<float> sum);

}  // namespace emulsion
