#pragma once
// The loop that all gamut mappers share: pixels inside the gamut are left as they are.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/color.h"
#include "display/code_value.h"
#include "display/gamut_counts.h"
#include "display/gamut_rows.h"

namespace emulsion {

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

inline constexpr std::size_t kGamutBlock_px = 64;

/// Replaces each pixel that is not inside by inside(pixel, excess), with the largest distance of a component from
/// [0, 1], and counts. Blocks of pixels that are all inside, as most are, are only looked at.
template <class Inside>
GamutCounts map_outside(std::span<RGB> linear, const Inside& inside) noexcept {
    GamutCounts counts;
    for (std::size_t begin = 0; begin < linear.size(); begin += kGamutBlock_px) {
        const std::span<RGB> block = linear.subspan(begin, std::min(kGamutBlock_px, linear.size() - begin));
        if (all_inside(block)) continue;
        std::array<float, kGamutBlock_px> excess{};
        counts += measure_row(block, std::span(excess).first(block.size()));
        for (std::size_t i = 0; i < block.size(); ++i) block[i] = inside(block[i], excess[i]);
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
