#pragma once
// Pictures for the tests of tone mapping.

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/color.h"
#include "core/image.h"
#include "core/random.h"

namespace emulsion {

/// A pixel of equal-energy chromaticity.
[[nodiscard]] inline XYZ grey(float luminance_cdm2) noexcept {
    return {luminance_cdm2, luminance_cdm2, luminance_cdm2};
}

/// One row of greys.
[[nodiscard]] inline Image<XYZ> row_of_greys(const std::vector<float>& luminances_cdm2) {
    Image<XYZ> scene(static_cast<int>(luminances_cdm2.size()), 1);
    for (std::size_t x = 0; x < luminances_cdm2.size(); ++x) scene.pixels()[x] = grey(luminances_cdm2[x]);
    return scene;
}

/// One row of greys in equal ratios from least to most.
[[nodiscard]] inline Image<XYZ> ramp_of_greys(double least_cdm2, double most_cdm2, int count) {
    Image<XYZ> scene(count, 1);
    for (int x = 0; x < count; ++x) {
        scene(x, 0) = grey(static_cast<float>(least_cdm2 * std::pow(most_cdm2 / least_cdm2, x / (count - 1.0))));
    }
    return scene;
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

/// Waves over some four decades about 1 cd/m^2, with a tenth of noise, as pictures have it; no bad pixels.
[[nodiscard]] inline Image<XYZ> smooth_scene(int width, int height, unsigned seed) {
    Pcg32 random(seed);
    Image<XYZ> scene(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float wave =
                std::sin(0.11f * static_cast<float>(x)) + std::cos(0.07f * static_cast<float>(x + 2 * y));
            const float luminance = std::pow(10.0f, wave) * (0.95f + 0.1f * random.next_float());
            scene(x, y) = {0.9f * luminance, luminance, 1.2f * luminance};
        }
    }
    return scene;
}

}  // namespace emulsion
