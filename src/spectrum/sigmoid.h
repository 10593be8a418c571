#pragma once

#include <array>
#include <cmath>

#include "core/units.h"

namespace emulsion {

/// 1/2 + x / (2 sqrt(1 + x^2)), from 0 at minus infinity to 1 at infinity; in a form that has no cancellation for x <
/// 0, so that small reflectances keep their digits. Source: Jakob & Hanika, "A Low-Dimensional Function Space for
/// Efficient Spectral Upsampling", EG 2019, eq. 4.
template <class T>
[[nodiscard]] T sigmoid(T x) noexcept {
    const T root = std::sqrt(T(1) + x * x);
    const T tail = T(0.5) / (root * (root + std::abs(x)));  // sigmoid(-|x|)
    return x < T(0) ? tail : T(1) - tail;
}

/// The x of sigmoid(x) = value; value in [0, 1], infinite at both ends.
template <class T>
[[nodiscard]] T inverse_sigmoid(T value) noexcept {
    return (value - T(0.5)) / std::sqrt(value * (T(1) - value));
}

// Two ways to write the polynomial inside a sigmoid: c0 t^2 + c1 t + c2 with t = (lambda - 360 nm) / 470 nm, as
// published and as SigmoidSpectrum has it; and "centred", k0 s^2 + k1 s + k2 with s = (lambda - 550 nm) / 100 nm: about
// where the eye sees, which makes the three coefficients matter alike and loses the fewest digits.
inline constexpr double kSigmoidCentre_nm = 550.0;
inline constexpr double kSigmoidWidth_nm = 100.0;

/// The c of centred coefficients k.
[[nodiscard]] inline std::array<double, 3> sigmoid_from_centred(const std::array<double, 3>& k) noexcept {
    // s = scale * t + offset
    constexpr double kScale = (kMaxWavelength_nm - kMinWavelength_nm) / kSigmoidWidth_nm;
    constexpr double kOffset = (kMinWavelength_nm - kSigmoidCentre_nm) / kSigmoidWidth_nm;
    return {k[0] * kScale * kScale, (2.0 * k[0] * kOffset + k[1]) * kScale, (k[0] * kOffset + k[1]) * kOffset + k[2]};
}

/// The centred coefficients of c.
[[nodiscard]] inline std::array<double, 3> centred_from_sigmoid(const std::array<double, 3>& c) noexcept {
    // t = scale * s + offset
    constexpr double kScale = kSigmoidWidth_nm / (kMaxWavelength_nm - kMinWavelength_nm);
    constexpr double kOffset = (kSigmoidCentre_nm - kMinWavelength_nm) / (kMaxWavelength_nm - kMinWavelength_nm);
    return {c[0] * kScale * kScale, (2.0 * c[0] * kOffset + c[1]) * kScale, (c[0] * kOffset + c[1]) * kOffset + c[2]};
}

}  // namespace emulsion
