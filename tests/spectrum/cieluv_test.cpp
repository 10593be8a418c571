#include "spectrum/cieluv.h"

#include <cmath>

#include <gtest/gtest.h>

#include "spectrum/cielab.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

const XYZd kWhite = xyz_of(Chromaticity{0.3127, 0.329});

Luv luv_of_srgb(double r, double g, double b) {
    const auto [x, y, z] = xyz_from_rgb(rgb_space("sRGB")) * std::array{r, g, b};
    return luv_from_xyz({x, y, z}, kWhite);
}

TEST(Luv, OfTheWhiteAndOfBlack) {
    EXPECT_EQ(luv_from_xyz(kWhite, kWhite), (Luv{100.0, 0.0, 0.0}));
    EXPECT_EQ(luv_from_xyz({}, kWhite), Luv{});
    EXPECT_EQ(xyz_from_luv({}, kWhite), XYZd{});
}

// Often said to be positive, but both chromatic components have both signs: the known values for sRGB. L* is that of
// the luminances of its matrix, 0.212639, 0.715169 and 0.072192.
TEST(Luv, OfThePrimariesOfSrgb) {
    const Luv red = luv_of_srgb(1.0, 0.0, 0.0), green = luv_of_srgb(0.0, 1.0, 0.0), blue = luv_of_srgb(0.0, 0.0, 1.0);
    EXPECT_NEAR(red.l, 53.24, 5e-3);
    EXPECT_NEAR(red.u, 175.0, 0.05);
    EXPECT_NEAR(red.v, 37.8, 0.05);
    EXPECT_NEAR(green.l, 87.74, 5e-3);
    EXPECT_NEAR(green.u, -83.1, 0.05);
    EXPECT_NEAR(green.v, 107.4, 0.05);
    EXPECT_NEAR(blue.l, 32.30, 5e-3);
    EXPECT_NEAR(blue.u, -9.4, 0.05);
    EXPECT_NEAR(blue.v, -130.4, 0.05);
}

// The example of the "colour" package (Mansencal et al.) for XYZ_to_Luv; XYZ has 8 decimals, times a slope of up to
// 1e3.
TEST(Luv, OfAPublishedExample) {
    const Luv luv = luv_from_xyz({0.20654008, 0.12197225, 0.05136952}, kWhite);
    EXPECT_NEAR(luv.l, 41.52787529, 5e-6);
    EXPECT_NEAR(luv.u, 96.83626054, 5e-6);
    EXPECT_NEAR(luv.v, 17.75210149, 5e-6);
}

TEST(Luv, HasTheLightnessOfLabAlsoInTheToeAndBelowZero) {
    for (const double y : {-0.3, -1e-3, 1e-3, 216.0 / 24389.0, 0.2, 1.7}) {
        const XYZd xyz = {0.2, y, 0.4};
        EXPECT_EQ(luv_from_xyz(xyz, kWhite).l, lab_from_xyz(xyz, kWhite).l);
    }
    EXPECT_NEAR(luv_from_xyz({0.2, -0.3, 0.4}, kWhite).l, -0.3 * 24389.0 / 27.0, 1e-12);
}

TEST(Luv, ForgetsTheChromaticityWithoutLuminance) {
    EXPECT_EQ(luv_from_xyz({0.5, 0.0, 0.5}, kWhite), Luv{});
    // X + 15 Y + 3 Z = 0 has no u', v'.
    EXPECT_FALSE(std::isfinite(luv_from_xyz({-3.0, 1.0, -4.0}, kWhite).u));
    EXPECT_FALSE(std::isfinite(xyz_from_luv({0.0, 1.0, 0.0}, kWhite).x));
}

TEST(Luv, AsChromaAndHue) {
    EXPECT_EQ(lch_from_luv({50.0, 3.0, 4.0}).chroma, 5.0);
    EXPECT_DOUBLE_EQ(lch_from_luv({50.0, 3.0, 4.0}).hue_deg, 53.13010235415598);  // atan(4/3)
    const Luv back = luv_from_lch({50.0, 5.0, 53.13010235415598});
    EXPECT_NEAR(back.u, 3.0, 1e-14);
    EXPECT_NEAR(back.v, 4.0, 1e-14);
}

}  // namespace
}  // namespace emulsion
