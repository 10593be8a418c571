#pragma once
// Gaussian blurs of a few pixels, by direct sums along rows and columns, the picture being mirrored at its edges.

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
