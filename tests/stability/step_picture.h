#pragma once
// A step of 1 : 1000, and what a plain local operator makes of it.

#include <cstddef>

#include "core/color.h"
#include "core/image.h"
#include "tonemap/gaussian_blur.h"

namespace emulsion::stability {

/// Dark on the left, bright on the right of x = 256.
inline Image<XYZ> step() {
    Image<XYZ> scene(512, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 512; ++x) {
            const float luminance = x < 256 ? 1.0f : 1000.0f;
            scene(x, y) = {luminance, luminance, luminance};
        }
    }
    return scene;
}

/// L / (L + S), S the Gaussian mean of the surroundings, which beside the bright plane is mostly not the pixel's own.
inline Image<XYZ> over_gaussian_surround(const Image<XYZ>& scene) {
    Image<float> luminance(scene.width(), scene.height());
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) luminance.pixels()[i] = scene.pixels()[i].y;
    const Image<float> surround = gaussian_blur(luminance, 16.0, 1);
    Image<XYZ> mapped(scene.width(), scene.height());
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
        const float l = luminance.pixels()[i], display = l / (l + surround.pixels()[i]);
        mapped.pixels()[i] = {display, display, display};
    }
    return mapped;
}

}  // namespace emulsion::stability
