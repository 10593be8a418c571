#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "spectrum/hsl.h"
#include "spectrum/hsv.h"

namespace emulsion {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void expect_near(const RGBd& rgb, const RGBd& expected, double tolerance) {
    EXPECT_NEAR(rgb.r, expected.r, tolerance);
    EXPECT_NEAR(rgb.g, expected.g, tolerance);
    EXPECT_NEAR(rgb.b, expected.b, tolerance);
}

TEST(Hsv, OfTheCornersOfTheCube) {
    EXPECT_EQ(hsv_from_rgb({1.0, 0.0, 0.0}), (Hsv{0.0, 1.0, 1.0}));
    EXPECT_EQ(hsv_from_rgb({1.0, 1.0, 0.0}), (Hsv{60.0, 1.0, 1.0}));
    EXPECT_EQ(hsv_from_rgb({0.0, 1.0, 0.0}), (Hsv{120.0, 1.0, 1.0}));
    EXPECT_EQ(hsv_from_rgb({0.0, 1.0, 1.0}), (Hsv{180.0, 1.0, 1.0}));
    EXPECT_EQ(hsv_from_rgb({0.0, 0.0, 1.0}), (Hsv{240.0, 1.0, 1.0}));
    EXPECT_EQ(hsv_from_rgb({1.0, 0.0, 1.0}), (Hsv{300.0, 1.0, 1.0}));
    EXPECT_EQ(hsv_from_rgb({1.0, 1.0, 1.0}), (Hsv{0.0, 0.0, 1.0}));
    EXPECT_EQ(hsv_from_rgb({0.0, 0.0, 0.0}), Hsv{});
}

TEST(Hsl, OfTheCornersOfTheCube) {
    EXPECT_EQ(hsl_from_rgb({1.0, 0.0, 0.0}), (Hsl{0.0, 1.0, 0.5}));
    EXPECT_EQ(hsl_from_rgb({0.0, 1.0, 1.0}), (Hsl{180.0, 1.0, 0.5}));
    EXPECT_EQ(hsl_from_rgb({1.0, 1.0, 1.0}), (Hsl{0.0, 0.0, 1.0}));
    EXPECT_EQ(hsl_from_rgb({0.0, 0.0, 0.0}), Hsl{});
}

struct Example {
    RGBd rgb;
    double hue_deg, saturation_hsv, value, saturation_hsl, lightness;
};

// Examples of the table in Wikipedia's "HSL and HSV", all numbers to three decimals, hue to one.
constexpr std::array<Example, 6> kExamples = {Example{{0.628, 0.643, 0.142}, 61.8, 0.779, 0.643, 0.638, 0.393},
                                              Example{{0.255, 0.104, 0.918}, 251.1, 0.887, 0.918, 0.832, 0.511},
                                              Example{{0.116, 0.675, 0.255}, 134.9, 0.828, 0.675, 0.707, 0.396},
                                              Example{{0.704, 0.187, 0.897}, 283.7, 0.792, 0.897, 0.775, 0.542},
                                              Example{{0.931, 0.463, 0.316}, 14.3, 0.661, 0.931, 0.817, 0.624},
                                              Example{{0.099, 0.795, 0.591}, 162.4, 0.875, 0.795, 0.779, 0.447}};

TEST(HsvAndHsl, OfThePublishedExamples) {
    for (const Example& example : kExamples) {
        const Hsv hsv = hsv_from_rgb(example.rgb);
        const Hsl hsl = hsl_from_rgb(example.rgb);
        // RGB is rounded to 5e-4: twice that over the chroma, which is above 0.5, makes 0.12 degrees and 2e-3.
        EXPECT_NEAR(hsv.hue_deg, example.hue_deg, 0.12 + 0.05);
        EXPECT_EQ(hsl.hue_deg, hsv.hue_deg);
        EXPECT_NEAR(hsv.saturation, example.saturation_hsv, 2e-3);
        EXPECT_EQ(hsv.value, example.value);
        EXPECT_NEAR(hsl.saturation, example.saturation_hsl, 2e-3);
        EXPECT_NEAR(hsl.lightness, example.lightness, 1e-3);
    }
}

TEST(HsvAndHsl, OutsideTheCubeGoThereAndBack) {
    for (const RGBd& rgb : {RGBd{1.5, 0.2, -0.4}, RGBd{-0.1, -0.5, -0.3}, RGBd{2.5, 1.5, 1.75}, RGBd{1.5, 1.5, 1.5},
                            RGBd{0.1, -0.6, -0.6}}) {
        expect_near(rgb_from_hsv(hsv_from_rgb(rgb)), rgb, 1e-15);
        expect_near(rgb_from_hsl(hsl_from_rgb(rgb)), rgb, 1e-15);
    }
}

TEST(HsvAndHsl, HaveSaturationsOutsideZeroToOneThere) {
    EXPECT_EQ(hsv_from_rgb({1.0, 0.0, -0.5}).saturation, 1.5);
    EXPECT_EQ(hsv_from_rgb({-0.5, -1.0, -1.0}).saturation, -1.0);
    EXPECT_EQ(hsl_from_rgb({1.25, 0.0, 0.0}).saturation, 1.25 / 0.75);
    EXPECT_EQ(hsl_from_rgb({2.0, 1.0, 1.0}).saturation, -1.0 / 1.0);
}

TEST(HsvAndHsl, HaveNoSaturationWhereTheirDivisorIsZero) {
    const Hsv hsv = hsv_from_rgb({0.0, -0.5, -0.25});
    EXPECT_TRUE(std::isinf(hsv.saturation));
    EXPECT_TRUE(std::isnan(rgb_from_hsv(hsv).r));
    for (const RGBd& rgb : {RGBd{0.5, -0.5, 0.0}, RGBd{1.5, 0.5, 1.0}}) {
        const Hsl hsl = hsl_from_rgb(rgb);
        EXPECT_TRUE(std::isinf(hsl.saturation));
        EXPECT_TRUE(std::isnan(rgb_from_hsl(hsl).r));
    }
}

TEST(HsvAndHsl, TakeAnyHue) {
    for (const double turn : {-720.0, -360.0, 360.0}) {
        expect_near(rgb_from_hsv({75.0 + turn, 0.5, 0.8}), rgb_from_hsv({75.0, 0.5, 0.8}), 1e-15);
        expect_near(rgb_from_hsl({75.0 + turn, 0.5, 0.3}), rgb_from_hsl({75.0, 0.5, 0.3}), 1e-15);
    }
    EXPECT_EQ(rgb_from_hsv({360.0, 1.0, 1.0}), (RGBd{1.0, 0.0, 0.0}));
}

TEST(HsvAndHsl, HueStaysBelow360) {
    EXPECT_EQ(hexagon_hue_deg({1.0, 0.0, 1e-17}), 0.0);
    EXPECT_LT(hexagon_hue_deg({1.0, 0.0, 1e-15}), 360.0);
    EXPECT_GT(hexagon_hue_deg({1.0, 0.0, 1e-12}), 359.0);
}

TEST(HsvAndHsl, KeepNan) {
    for (const RGBd& rgb : {RGBd{kNan, 0.0, 1.0}, RGBd{0.0, kNan, 1.0}, RGBd{0.0, 1.0, kNan}}) {
        EXPECT_TRUE(std::isnan(hsv_from_rgb(rgb).value));
        EXPECT_TRUE(std::isnan(hsl_from_rgb(rgb).lightness));
    }
}

}  // namespace
}  // namespace emulsion
