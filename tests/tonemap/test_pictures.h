#pragma once
// Pictures for the tests of tone mapping.

#include <cmath>

#include "core/color.h"
#include "core/image.h"
#include "core/random.h"

namespace emulsion {

/// A pixel of equal-energy chromaticity.
[[nodiscard]] inline XYZ grey(float luminance_cdm2) noexcept {
    return {luminance_cdm2, luminance_cdm2, luminance_cdm2};
}

/// Colours whose luminances spread over six decades, 1e-3 to 1e3 cd/m^2; no bad pixels.
[[nodiscard]] inline Image<XYZ> random_scene(int width, int height, unsigned seed) {
    Pcg32 random(seed);
    Image<XYZ> scene(width, height);
    for (XYZ& pixel : scene.pixels()) {
        const float luminance = std::pow(10.0f, 6.0f * random.next_float() - 3.0f);
        pixel = {luminance * 2.0f * random.next_float(), luminance, luminance * 2.0f * random.next_float()};
    }
    return scene;
}

}  // namespace emulsion
