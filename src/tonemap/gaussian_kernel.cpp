#include "tonemap/gaussian_kernel.h"

#include <cmath>
#include <numbers>

namespace emulsion {

std::vector<double> gaussian_kernel(double sigma_px, double tail) {
    if (sigma_px == 0.0) return {1.0};
    // Beyond x, to one side.
    const auto beyond = [&](double x) { return 0.5 * std::erfc(x / (sigma_px * std::numbers::sqrt2)); };
    std::vector<double> weights = {1.0 - 2.0 * beyond(0.5)};
    double sum = weights[0];
    for (int offset = 1; 2.0 * beyond(offset - 0.5) >= tail; ++offset) {
        weights.push_back(beyond(offset - 0.5) - beyond(offset + 0.5));
        sum += 2.0 * weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

}  // namespace emulsion
