#pragma once
// A cubic in place of a smooth function on [0, 1]: what filters are looked up by.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace emulsion {

/// c0 + t (c1 + t (c2 + t c3)).
struct CubicFit {
    std::array<double, 4> coefficient{};  ///< constant first
    double worst = 0.0;                   ///< the largest |cubic - f| at 17 points of [0, 1], both ends among them

    [[nodiscard]] double at(double t) const noexcept {
        const auto& c = coefficient;
        return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
    }
};

/// The integral of f^2 over [0, 1]: Gauss's rule of four abscissae on each of eight panels.
template <class F>
[[nodiscard]] double integral_of_square(const F& f) {
    constexpr int kPanels = 8;
    constexpr std::array<double, 2> kOffset = {0.8611363115940526 / 2.0, 0.3399810435848563 / 2.0};
    constexpr std::array<double, 2> kWeight = {0.3478548451374538 / 2.0, 0.6521451548625461 / 2.0};
    double sum = 0.0;
    for (int panel = 0; panel < kPanels; ++panel) {
        for (std::size_t i = 0; i < 2; ++i) {
            for (const double place : {0.5 - kOffset[i], 0.5 + kOffset[i]}) {
                const double value = f((panel + place) / kPanels);
                sum += kWeight[i] / kPanels * value * value;
            }
        }
    }
    return sum;
}

/// The cubic through the values of f at the four Chebyshev points of [0, 1].
template <class F>
[[nodiscard]] CubicFit fit_cubic(const F& f) {
    std::array<double, 4> node{}, difference{};
    for (std::size_t i = 0; i < 4; ++i) {
        node[i] = 0.5 - 0.5 * std::cos((2.0 * static_cast<double>(i) + 1.0) * std::numbers::pi / 8.0);
        difference[i] = f(node[i]);
    }
    // Newton's divided differences, then Horner's scheme on polynomials.
    for (std::size_t order = 1; order < 4; ++order) {
        for (std::size_t i = 3; i >= order; --i) {
            difference[i] = (difference[i] - difference[i - 1]) / (node[i] - node[i - order]);
        }
    }
    CubicFit fit;
    for (std::size_t i = 4; i-- > 0;) {
        for (std::size_t k = 3; k > 0; --k) {
            fit.coefficient[k] = fit.coefficient[k - 1] - node[i] * fit.coefficient[k];
        }
        fit.coefficient[0] = difference[i] - node[i] * fit.coefficient[0];
    }
    for (int k = 0; k <= 16; ++k) {
        const double t = k / 16.0;
        fit.worst = std::max(fit.worst, std::abs(fit.at(t) - f(t)));
    }
    return fit;
}

}  // namespace emulsion
