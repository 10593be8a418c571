#pragma once
// RGBE: three significands of 8 bits with one exponent.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/color.h"

namespace emulsion {

/// component[0..2] 2^(component[3] - 136); {0, 0, 0, 0} is black.
/// Source: G. Ward, "Real Pixels", Graphics Gems II, 1991.
using Rgbe = std::array<std::uint8_t, 4>;

/// The nearest: each component within 1/255.5 (0.39 %) of the largest one. 0 if that is below 2^-128 (2.9e-39) or so.
/// \param rgb in [0, 255/256 2^127 = 1.69e38]
[[nodiscard]] inline Rgbe to_rgbe(const RGB& rgb) noexcept {
    const float largest = std::max({rgb.r, rgb.g, rgb.b});
    int exponent = 0;
    (void)std::frexp(largest, &exponent);
    if (std::lrint(std::ldexp(largest, 8 - exponent)) > 255) ++exponent;
    if (!(largest > 0.0f) || exponent < -127) return {};  // the exponent 0 is black
    const auto significand = [&](float v) {
        return static_cast<std::uint8_t>(std::lrint(std::ldexp(static_cast<double>(v), 8 - exponent)));
    };
    return {significand(rgb.r), significand(rgb.g), significand(rgb.b), static_cast<std::uint8_t>(exponent + 128)};
}

/// As written above, as pfstools and OpenImageIO read it; Radiance itself, which rounds down, adds half a step.
[[nodiscard]] inline RGB from_rgbe(const Rgbe& rgbe) noexcept {
    if (rgbe[3] == 0) return {};
    const float step = std::ldexp(1.0f, rgbe[3] - 136);
    return {step * static_cast<float>(rgbe[0]), step * static_cast<float>(rgbe[1]), step * static_cast<float>(rgbe[2])};
}

}  // namespace emulsion
