#pragma once
// Classes of pixels, the first that fits: nan (a component is NaN), negative (Y < 0, -Inf included), infinite (a
// component is infinite), zero (Y = 0), positive. nan, negative and infinite pixels are bad: counted and left out.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/color.h"

namespace emulsion {

enum class PixelClass { positive, zero, negative, nan, infinite };

[[nodiscard]] inline PixelClass classify(const XYZ& pixel) noexcept {
    if (std::isnan(pixel.x) || std::isnan(pixel.y) || std::isnan(pixel.z)) return PixelClass::nan;
    if (pixel.y < 0.0f) return PixelClass::negative;
    if (std::isinf(pixel.x) || std::isinf(pixel.y) || std::isinf(pixel.z)) return PixelClass::infinite;
    return pixel.y == 0.0f ? PixelClass::zero : PixelClass::positive;
}

/// Largest |X|, |Y| or |Z|.
[[nodiscard]] inline float max_component(const XYZ& pixel) noexcept {
    return std::max({std::abs(pixel.x), std::abs(pixel.y), std::abs(pixel.z)});
}

[[nodiscard]] constexpr bool is_bad(PixelClass pixel_class) noexcept {
    return pixel_class != PixelClass::positive && pixel_class != PixelClass::zero;
}

struct PixelCounts {
    std::int64_t positive = 0, zero = 0, negative = 0, nan = 0, infinite = 0;

    [[nodiscard]] std::int64_t bad() const noexcept { return negative + nan + infinite; }
    void add(PixelClass pixel_class) noexcept;
    PixelCounts& operator+=(const PixelCounts& other) noexcept;
    bool operator==(const PixelCounts&) const = default;
};

}  // namespace emulsion
