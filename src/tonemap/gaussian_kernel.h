#pragma once
// Gaussians on pixels.

#include <vector>

namespace emulsion {

/// The weights of offsets 0, 1, ..., r, the same for negative ones, of a Gaussian of standard deviation `sigma_px`, in
/// [0, 1e6], integrated over each pixel by error functions, so that narrow ones sum to 1, too: sampled at pixel
/// centres, one of 0.25 pixels would sum to 2.55. r is the least for which less than `tail`, in (0, 1), lies outside;
/// what is left is scaled to sum to 1. The variance on the pixels is sigma^2 + 1/12, for sigma > 0.5 to five digits.
[[nodiscard]] std::vector<double> gaussian_kernel(double sigma_px, double tail);

}  // namespace emulsion
