#pragma once
// How much two pictures look alike, as one number: mean structural similarity.

#include <array>
#include <cmath>
#include <cstddef>

#include "core/image.h"

namespace emulsion {

/// 1 for the same pictures, less the more that local means, contrasts or shapes differ, down to -1. Means, variances
/// and the covariance are those under a Gaussian of 11 x 11 pixels with sigma 1.5, where it fits into the picture.
/// Source: Wang, Bovik, Sheikh & Simoncelli, "Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE Trans. Image Processing 13(4), 2004, eq. 13 to 17, with its K1 and K2.
/// \param range of the values: 100 for lightness
inline double structural_similarity(const Image<double>& one, const Image<double>& other, double range) {
    constexpr int kSize = 11;
    std::array<double, kSize> weights{};
    double total = 0.0;
    for (int i = 0; i < kSize; ++i) total += weights[i] = std::exp(-0.5 * (i - 5) * (i - 5) / (1.5 * 1.5));
    const double c1 = 0.01 * 0.01 * range * range, c2 = 0.03 * 0.03 * range * range;
    double sum = 0.0;
    std::size_t count = 0;
    for (int y = 0; y + kSize <= one.height(); ++y) {
        for (int x = 0; x + kSize <= one.width(); ++x, ++count) {
            double a = 0.0, b = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
            for (int j = 0; j < kSize; ++j) {
                for (int i = 0; i < kSize; ++i) {
                    const double weight = weights[i] * weights[j] / (total * total);
                    const double p = one(x + i, y + j), q = other(x + i, y + j);
                    a += weight * p;
                    b += weight * q;
                    aa += weight * p * p;
                    bb += weight * q * q;
                    ab += weight * p * q;
                }
            }
            sum += (2.0 * a * b + c1) * (2.0 * (ab - a * b) + c2) /
                   ((a * a + b * b + c1) * (aa - a * a + bb - b * b + c2));
        }
    }
    return sum / static_cast<double>(count);
}

}  // namespace emulsion
