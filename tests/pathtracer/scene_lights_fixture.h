#pragma once
// What the tests of lights in scene texts share: their lights, and these in photometric units.

#include <numbers>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "scene_text.h"
#include "spectrum/colorimetry.h"

namespace emulsion {

inline constexpr double kPi = std::numbers::pi;

/// cd/m^2 of a radiance, cd of an intensity, lux of an irradiance.
inline double photometric(const ScaledSpectrum& light) { return light.scale * xyz_of_radiance(light.spectrum).y; }

template <class T>
T only_light(const std::string& text) {
    return std::get<T>(testing::parse_world(text).lights.at(0));
}

/// The area light of a unit square.
inline AreaLight square_light(const std::string& area_light, const std::string& before_shape = "") {
    const Scene scene = testing::parse_world("AreaLightSource \"diffuse\" " + area_light + " " + before_shape +
                                             R"( Shape "bilinearmesh" "point3 P" [0 0 0  1 0 0  0 1 0  1 1 0])");
    return scene.shapes.at(0).area_light.value();
}

// 1e-6: the normalisation is exact for straight lines, and good to 1e-9 for the smooth ones.
inline void expect_photometric(const ScaledSpectrum& light, double expected, const std::string& what) {
    EXPECT_NEAR(photometric(light) / expected, 1.0, 1e-6) << what;
}

}  // namespace emulsion
