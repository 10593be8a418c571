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

namespace emulsion {

/// Distance from [0, 1], 0 inside; 0 for NaN.
[[nodiscard]] inline float gamut_excess(float component) noexcept {
    const float below = 0.0f < -component ? -component : 0.0f;
    return below < component - 1.0f ? component - 1.0f : below;
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

inline constexpr std::size_t kGamutBlock_px = 64;

/// What is outside in a block, and by how much: the largest distance of a component from [0, 1] for each pixel.
struct GamutBlock {
    std::array<float, kGamutBlock_px> excess{};
    GamutCounts counts;
};

/// \param block of up to kGamutBlock_px pixels. Loops without branches, which compilers make vectors of.
[[nodiscard]] inline GamutBlock measure(std::span<const RGB> block) noexcept {
    GamutBlock found;
    std::array<std::int32_t, kGamutBlock_px> nan{};
    for (std::size_t i = 0; i < block.size(); ++i) {
        const RGB& p = block[i];
        nan[i] = static_cast<std::int32_t>(p.r != p.r) | static_cast<std::int32_t>(p.g != p.g) |
                 static_cast<std::int32_t>(p.b != p.b);
        found.excess[i] = std::max(std::max(gamut_excess(p.r), gamut_excess(p.g)), gamut_excess(p.b));
    }
    std::int32_t nans = 0, outside = 0, largest = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
        nans += nan[i];
        outside += static_cast<std::int32_t>(found.excess[i] > kGamutTolerance) & ~nan[i];
        // Floats that aren't negative are in the order of their bits.
        largest = std::max(largest, std::bit_cast<std::int32_t>(found.excess[i]));
    }
    found.counts = {outside, nans, std::bit_cast<float>(largest)};
    return found;
}

/// Replaces each pixel that is not inside by inside(pixel, excess), with the largest distance of a component from
/// [0, 1], and counts. Blocks of pixels that are all inside, as most are, are only looked at.
template <class Inside>
GamutCounts map_outside(std::span<RGB> linear, const Inside& inside) noexcept {
    GamutCounts counts;
    for (std::size_t begin = 0; begin < linear.size(); begin += kGamutBlock_px) {
        const std::span<RGB> block = linear.subspan(begin, std::min(kGamutBlock_px, linear.size() - begin));
        if (all_inside(block)) continue;
        const GamutBlock found = measure(block);
        counts += found.counts;
        for (std::size_t i = 0; i < block.size(); ++i) block[i] = inside(block[i], found.excess[i]);
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
