#pragma once
// The loop that all gamut mappers share: pixels inside the gamut are left as they are.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/color.h"
#include "display/code_value.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Distance from [0, 1], 0 inside; 0 for NaN.
[[nodiscard]] inline float gamut_excess(float component) noexcept {
    return std::max({0.0f, -component, component - 1.0f});
}

/// The nearest colour component by component; NaN and -0 as +0.
[[nodiscard]] constexpr RGB clipped(const RGB& rgb) noexcept {
    return {unit_clamp(rgb.r), unit_clamp(rgb.g), unit_clamp(rgb.b)};
}

/// Whether all components are in [0, 1], and none is -0: as an integer, such a float is at most 1's.
[[nodiscard]] inline bool all_inside(std::span<const RGB> linear) noexcept {
    std::uint32_t largest = 0;
    for (const RGB& rgb : linear) {
        largest = std::max(largest, std::bit_cast<std::uint32_t>(rgb.r));
        largest = std::max(largest, std::bit_cast<std::uint32_t>(rgb.g));
        largest = std::max(largest, std::bit_cast<std::uint32_t>(rgb.b));
    }
    return largest <= std::bit_cast<std::uint32_t>(1.0f);
}

/// Replaces each pixel that is not inside by inside(pixel, excess), with the largest distance of a component from
/// [0, 1], and counts. Blocks of pixels that are all inside, as most are, are only looked at.
template <class Inside>
GamutCounts map_outside(std::span<RGB> linear, const Inside& inside) noexcept {
    constexpr std::size_t kBlock_px = 64;
    GamutCounts counts;
    for (std::size_t begin = 0; begin < linear.size(); begin += kBlock_px) {
        const std::span<RGB> block = linear.subspan(begin, std::min(kBlock_px, linear.size() - begin));
        if (all_inside(block)) continue;
        for (RGB& rgb : block) {
            const bool nan = std::isnan(rgb.r) || std::isnan(rgb.g) || std::isnan(rgb.b);
            const float largest = std::max({gamut_excess(rgb.r), gamut_excess(rgb.g), gamut_excess(rgb.b)});
            counts.nan += nan ? 1 : 0;
            counts.outside += !nan && largest > kGamutTolerance ? 1 : 0;
            counts.largest_excess = std::max(counts.largest_excess, largest);
            rgb = inside(rgb, largest);
        }
    }
    return counts;
}

/// For a mapper whose double-precision twin takes finite colours: those outside by more than rounding go to it, NaN as
/// 0 and infinities as 2^100; the others are clipped.
template <class Twin>
GamutCounts map_outside_exactly(std::span<RGB> linear, const Twin& twin) noexcept {
    const auto finite = [](float v) noexcept {
        return std::isnan(v) ? 0.0 : static_cast<double>(std::clamp(v, -0x1p100f, 0x1p100f));
    };
    return map_outside(linear, [&](const RGB& rgb, float excess) noexcept {
        if (excess <= kGamutTolerance) return clipped(rgb);
        const RGBd mapped = twin(RGBd{finite(rgb.r), finite(rgb.g), finite(rgb.b)});
        return clipped({static_cast<float>(mapped.r), static_cast<float>(mapped.g), static_cast<float>(mapped.b)});
    });
}

}  // namespace emulsion
