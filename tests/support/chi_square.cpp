#include "support/chi_square.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace emulsion::testing {

namespace {

constexpr double kRelativeEnd = 1e-16;  // terms that no longer change a sum

/// P(a, x) by its series, for x < a + 1.
double lower_by_series(double a, double x) {
    double term = 1.0 / a, sum = term;
    for (double n = a + 1.0; term > sum * kRelativeEnd; n += 1.0) {
        term *= x / n;
        sum += term;
    }
    return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// Q(a, x) by its continued fraction, for x >= a + 1; evaluated from the front by Lentz's method.
double upper_by_fraction(double a, double x) {
    double b = x + 1.0 - a, c = 1.0 / std::numeric_limits<double>::min(), d = 1.0 / b, product = d;
    for (int i = 1; i < 100000; ++i) {
        const double numerator = -i * (i - a);
        b += 2.0;
        d = 1.0 / (numerator * d + b);
        c = b + numerator / c;
        product *= c * d;
        if (std::abs(c * d - 1.0) < kRelativeEnd) break;
    }
    return product * std::exp(a * std::log(x) - x - std::lgamma(a));
}

void check(std::span<const double> observed, std::span<const double> expected) {
    if (observed.size() != expected.size()) throw std::invalid_argument("chi-square: bins of different number");
    const auto is_count = [](double count) { return std::isfinite(count) && count >= 0.0; };
    if (!std::all_of(observed.begin(), observed.end(), is_count) ||
        !std::all_of(expected.begin(), expected.end(), is_count)) {
        throw std::invalid_argument("chi-square: counts must be finite and >= 0");
    }
    const double seen = std::accumulate(observed.begin(), observed.end(), 0.0);
    const double awaited = std::accumulate(expected.begin(), expected.end(), 0.0);
    if (std::abs(seen - awaited) > 1e-4 * std::max(seen, awaited)) {
        throw std::invalid_argument("chi-square: " + std::to_string(seen) + " observed, " + std::to_string(awaited) +
                                    " expected");
    }
}

}  // namespace

ChiSquareResult chi_square_test(std::span<const double> observed, std::span<const double> expected) {
    check(observed, expected);
    std::vector<std::size_t> order(expected.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });

    ChiSquareResult result;
    double bins = 0.0, pooled_observed = 0.0, pooled_expected = 0.0;
    for (const std::size_t bin : order) {
        if (expected[bin] == 0.0 && observed[bin] > 0.0) return {std::numeric_limits<double>::infinity(), 0.0, 0.0};
        pooled_observed += observed[bin];
        pooled_expected += expected[bin];
        if (pooled_expected < kLeastExpectedCount) continue;
        const double difference = pooled_observed - pooled_expected;
        result.statistic += difference * difference / pooled_expected;
        bins += 1.0;
        pooled_observed = pooled_expected = 0.0;
    }
    // What is left in the pool are bins of less than five in all: there is no larger one to follow.
    if (bins < 2.0) return {};
    result.degrees_of_freedom = bins - 1.0;
    result.p_value = chi_square_tail(result.statistic, result.degrees_of_freedom);
    return result;
}

double chi_square_tail(double statistic, double degrees_of_freedom) {
    return upper_incomplete_gamma(0.5 * degrees_of_freedom, 0.5 * statistic);
}

double upper_incomplete_gamma(double a, double x) {
    if (!(a > 0.0) || !(x >= 0.0)) throw std::invalid_argument("upper_incomplete_gamma: a must be > 0, x >= 0");
    if (x == 0.0) return 1.0;
    if (std::isinf(x)) return 0.0;
    return x < a + 1.0 ? 1.0 - lower_by_series(a, x) : upper_by_fraction(a, x);
}

double sidak_level(double false_alarm, int tests) { return -std::expm1(std::log1p(-false_alarm) / tests); }

}  // namespace emulsion::testing
