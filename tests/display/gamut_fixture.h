#pragma once
// What the tests of gamut mappers share: displays, colours in and about their gamuts, and how far apart colours are.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/named_value.h"
#include "core/random.h"
#include "display/display.h"
#include "display/display_gamut.h"
#include "spectrum/oklab.h"

namespace emulsion {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInf = std::numeric_limits<float>::infinity();

inline bool same_bits(const RGB& a, const RGB& b) {
    return std::bit_cast<std::uint32_t>(a.r) == std::bit_cast<std::uint32_t>(b.r) &&
           std::bit_cast<std::uint32_t>(a.g) == std::bit_cast<std::uint32_t>(b.g) &&
           std::bit_cast<std::uint32_t>(a.b) == std::bit_cast<std::uint32_t>(b.b);
}

inline RGBd wide(const RGB& rgb) { return {rgb.r, rgb.g, rgb.b}; }

inline double distance(const RGBd& a, const RGBd& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// The defaults, and with a black of their own, in lit rooms.
inline std::vector<Display> all_displays() {
    std::vector<Display> all;
    for_each_alternative<Display>([&](const auto& display) {
        all.emplace_back(display);
        auto lit = display;
        lit.black_cdm2 = 0.5, lit.flare_cdm2 = 5.0;
        all.emplace_back(lit);
    });
    return all;
}

inline std::vector<DisplayGamut> all_gamuts() {
    std::vector<DisplayGamut> all;
    for (const Display& display : all_displays()) all.push_back(display_gamut(display));
    return all;
}

/// Linear RGB, some in the gamut, more around it, a few far out.
inline std::vector<RGB> colours_about_the_gamut(unsigned seed, int count) {
    Pcg32 random(seed);
    std::vector<RGB> colours;
    for (int i = 0; i < count; ++i) {
        const float size = i % 10 == 0 ? 100.0f : 1.0f;
        const auto component = [&] { return size * (1.6f * random.next_float() - 0.3f); };
        colours.push_back({component(), component(), component()});
    }
    return colours;
}

/// Of the light that is shown for a signal, with the display's white as Oklab's own.
inline Oklab oklab_of(const DisplayGamut& gamut, const RGBd& signal) {
    const auto cones = gamut.cones_from_rgb *
                       std::array{light_of(gamut, signal.r), light_of(gamut, signal.g), light_of(gamut, signal.b)};
    const auto lab = kOklabFromRoots * std::array{std::cbrt(cones[0]), std::cbrt(cones[1]), std::cbrt(cones[2])};
    return {lab[0], lab[1], lab[2]};
}

inline double hue_difference_deg(const Oklab& a, const Oklab& b) {
    const double difference = oklch_from_oklab(a).hue_deg - oklch_from_oklab(b).hue_deg;
    return std::abs(std::remainder(difference, 360.0));
}

}  // namespace emulsion
