#pragma once
// Pictures to compare.

#include <cmath>
#include <cstdint>
#include <utility>

#include "compare/compare.h"
#include "core/random.h"
#include "spectrum/observer.h"
#include "spectrum/viewing_conditions.h"

namespace emulsion {

/// The full frame, nothing known of its noise.
inline ComparedPicture whole(Image<XYZ> xyz) {
    const int width = xyz.width(), height = xyz.height();
    ComparedPicture picture{.xyz = {}, .window = {0, 0, width, height}, .width_px = width, .height_px = height};
    picture.xyz = std::move(xyz);
    return picture;
}

inline XYZ narrowed(const XYZd& xyz) {
    return {static_cast<float>(xyz.x), static_cast<float>(xyz.y), static_cast<float>(xyz.z)};
}

/// All pixels the same.
inline ComparedPicture constant(const XYZd& xyz, int width = 7, int height = 5) {
    Image<XYZ> image(width, height);
    for (XYZ& pixel : image.pixels()) pixel = narrowed(xyz);
    return whole(std::move(image));
}

inline XYZd d65() { return default_white(cie_1931_2deg()); }

/// Colours at random, luminances over four decades.
inline ComparedPicture random_picture(int width, int height, std::uint64_t seed) {
    Pcg32 random(seed);
    Image<XYZ> image(width, height);
    for (XYZ& pixel : image.pixels()) {
        const auto luminance = static_cast<float>(std::pow(10.0, 4.0 * random.next_float() - 1.0));
        pixel = {luminance * (0.5f + random.next_float()), luminance, luminance * (0.2f + random.next_float())};
    }
    return whole(std::move(image));
}

}  // namespace emulsion
