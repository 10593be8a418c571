#include "support/kolmogorov_smirnov.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace emulsion::testing {

KolmogorovSmirnovResult normality_test(std::vector<double> z_scores) {
    if (z_scores.empty()) throw std::invalid_argument("normality_test: no numbers");
    std::sort(z_scores.begin(), z_scores.end());
    const auto count = static_cast<double>(z_scores.size());
    double below = 0.0, distance = 0.0;
    for (const double z : z_scores) {
        const double cdf = normal_cdf(z);
        distance = std::max({distance, cdf - below / count, (below + 1.0) / count - cdf});
        below += 1.0;
    }
    return {distance, kolmogorov_tail(distance, count)};
}

double normal_cdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double kolmogorov_tail(double statistic, double count) {
    const double root = std::sqrt(count), x = (root + 0.12 + 0.11 / root) * statistic;
    if (x < 0.2) return 1.0;  // the series needs ever more terms, and is 1 to 1e-12
    double sum = 0.0;
    for (int k = 1; k <= 100; ++k) sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * x * x);
    return std::clamp(sum, 0.0, 1.0);
}

}  // namespace emulsion::testing
