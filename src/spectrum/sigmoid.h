#pragma once

#include <cmath>

namespace emulsion {

/// 1/2 + x / (2 sqrt(1 + x^2)), from 0 at minus infinity to 1 at infinity; in a form that has no cancellation for x <
/// 0, so that small reflectances keep their digits. Source: Jakob & Hanika, "A Low-Dimensional Function Space for
/// Efficient Spectral Upsampling", EG 2019, eq. 4.
[[nodiscard]] inline double sigmoid(double x) noexcept {
    const double root = std::sqrt(1.0 + x * x);
    const double tail = 0.5 / (root * (root + std::abs(x)));  // sigmoid(-|x|)
    return x < 0.0 ? tail : 1.0 - tail;
}

/// The x of sigmoid(x) = value; value in [0, 1], infinite at both ends.
[[nodiscard]] inline double inverse_sigmoid(double value) noexcept {
    return (value - 0.5) / std::sqrt(value * (1.0 - value));
}

}  // namespace emulsion
