#pragma once
// The function f of CIELAB (spectrum/cielab.h), of a tristimulus value relative to the white's. Inline, so that the
// solver of the sigmoid tables needs nothing else of the library.

#include <cmath>

namespace emulsion {

inline constexpr double kLabKnee = 6.0 / 29.0;                             ///< of f; that of its argument is the cube
inline constexpr double kLabToeSlope = 1.0 / (3.0 * kLabKnee * kLabKnee);  ///< of the cube root at the knee
inline constexpr double kLabToeOffset = 4.0 / 29.0;

/// The cube root, or below (6/29)^3 the straight line that continues it.
[[nodiscard]] inline double lab_f(double ratio) noexcept {
    if (ratio > kLabKnee * kLabKnee * kLabKnee) return std::cbrt(ratio);
    return kLabToeSlope * ratio + kLabToeOffset;
}

[[nodiscard]] inline double lab_f_derivative(double ratio) noexcept {
    if (ratio > kLabKnee * kLabKnee * kLabKnee) return 1.0 / (3.0 * std::cbrt(ratio) * std::cbrt(ratio));
    return kLabToeSlope;
}

}  // namespace emulsion
