#include "spectrum/integral_panels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace emulsion {

namespace {

/// The Legendre polynomial P_n and its derivative.
struct Legendre {
    double value, slope;
};

Legendre legendre(int n, double x) noexcept {
    double before = 1.0, value = x;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, n * (x * value - before) / (x * x - 1.0)};
}

/// The roots of P_n by Newton's method from Tricomi's approximation; weights 2 / ((1 - x^2) P_n'(x)^2).
/// Source: Abramowitz & Stegun, "Handbook of Mathematical Functions", 25.4.29.
QuadratureRule gauss_legendre(int n) {
    constexpr double kPi = 3.14159265358979323846;
    QuadratureRule rule;
    for (int i = n; i >= 1; --i) {
        double x = std::cos(kPi * (i - 0.25) / (n + 0.5));
        for (int step = 0; step < 10; ++step) {
            const Legendre p = legendre(n, x);
            x -= p.value / p.slope;
        }
        if (2 * i == n + 1) x = 0.0;
        const double slope = legendre(n, x).slope;
        rule.point.push_back(0.5 * (1.0 + x));
        rule.weight.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace

const QuadratureRule& gauss_rule(int degree) noexcept {
    constexpr std::size_t kCount = (kMaxGaussDegree + 1) / 2;
    static const std::array<QuadratureRule, kCount> rules = [] {
        std::array<QuadratureRule, kCount> made;
        for (std::size_t i = 0; i < kCount; ++i) made[i] = gauss_legendre(static_cast<int>(i) + 1);
        return made;
    }();
    return rules[static_cast<std::size_t>(std::clamp(degree, 0, kMaxGaussDegree)) / 2];
}

const KronrodRule& kronrod_rule() noexcept {
    static const KronrodRule rule = [] {
        // On [-1, 1], from the outside to the middle.
        constexpr std::array<double, 4> kPoint = {0.96049126870802028, 0.77459666924148338, 0.43424374934680256, 0.0};
        constexpr std::array<double, 4> kWeight = {0.10465622602646727, 0.26848808986833344, 0.40139741477596222,
                                                   0.45091653865847414};
        constexpr std::array<double, 4> kGaussWeight = {0.0, 5.0 / 9.0, 0.0, 8.0 / 9.0};
        KronrodRule made{};
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t mirror = 6 - i;
            made.point[i] = 0.5 * (1.0 - kPoint[i]);
            made.point[mirror] = 0.5 * (1.0 + kPoint[i]);
            made.weight[i] = made.weight[mirror] = 0.5 * kWeight[i];
            made.gauss_weight[i] = made.gauss_weight[mirror] = 0.5 * kGaussWeight[i];
        }
        return made;
    }();
    return rule;
}

}  // namespace emulsion
