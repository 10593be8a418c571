#pragma once
// The loop that all pointwise operators share: one scale for each pixel, from its luminance.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "core/color.h"
#include "tonemap/pixel_class.h"
#include "tonemap/scale_rows.h"

namespace emulsion {

/// One pixel in double precision. `exact_scale(luminance_cdm2)` is asked for good pixels only.
template <class ExactScale>
[[nodiscard]] XYZd scaled_pixel(const XYZ& pixel, const XYZd& display_white, const ExactScale& exact_scale) noexcept {
    switch (classify(pixel)) {
        case PixelClass::nan:
        case PixelClass::negative:
            return {};
        case PixelClass::infinite:
            return display_white;
        case PixelClass::zero:
        case PixelClass::positive:
            break;
    }
    const XYZd exact{pixel.x, pixel.y, pixel.z};
    const XYZd scaled = exact_scale(exact.y) * exact;
    const double largest = std::max({std::abs(scaled.x), std::abs(scaled.y), std::abs(scaled.z)});
    return largest > kMaxDisplayComponent ? (kMaxDisplayComponent / largest) * scaled : scaled;
}

/// The value in single precision, or NaN where that would cost digits: scale_pixels() then takes the exact scale.
[[nodiscard]] inline float narrow_or_nan(double value) noexcept {
    const bool representable = value == 0.0 || (value > 0x1p-120 && value < 0x1p120);
    return representable ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

/// display = scale * scene for pixels of a row, with bad ones as tone_map() says. `scale_row` is one of scale_rows.h;
/// pixels that it leaves are scaled by `exact_scale_at(i)`, which gives a function of Y in double precision.
template <class ScaleRow, class ExactScaleAt>
void scale_pixels(std::span<const XYZ> scene, std::span<XYZ> display, const XYZ& display_white,
                  const ScaleRow& scale_row, const ExactScaleAt& exact_scale_at) {
    LeftPixels left;
    scale_row(scene, display, left);
    const XYZd white{display_white.x, display_white.y, display_white.z};
    for (const std::size_t i : left) {
        const XYZd scaled = scaled_pixel(display[i], white, exact_scale_at(i));
        display[i] = {static_cast<float>(scaled.x), static_cast<float>(scaled.y), static_cast<float>(scaled.z)};
    }
}

}  // namespace emulsion
