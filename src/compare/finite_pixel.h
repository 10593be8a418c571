#pragma once

#include <cmath>

#include "core/color.h"

namespace emulsion {

[[nodiscard]] inline bool is_finite(const XYZ& pixel) noexcept {
    return std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z);
}

}  // namespace emulsion
