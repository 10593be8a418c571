#pragma once
// Code values: what a file or a display is sent. 8 bits, full range: 0 is encoded 0, 255 is encoded 1.

#include <cstdint>

#include "core/color.h"

namespace emulsion {

using CodeRGB = BasicRGB<std::uint8_t>;

inline constexpr int kMaxCode = 255;

/// A component for the quantizers: NaN as 0, others to the nearest value in [0, 1].
[[nodiscard]] constexpr float unit_clamp(float encoded) noexcept {
    const float above = encoded > 0.0f ? encoded : 0.0f;
    return above < 1.0f ? above : 1.0f;
}

}  // namespace emulsion
