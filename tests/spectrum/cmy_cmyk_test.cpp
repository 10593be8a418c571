#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "spectrum/cmy.h"
#include "spectrum/cmyk.h"

namespace emulsion {
namespace {

TEST(Cmy, IsTheComplement) {
    EXPECT_EQ(cmy_from_rgb({1.0, 0.25, -0.5}), (Cmy{0.0, 0.75, 1.5}));
    EXPECT_EQ(rgb_from_cmy({0.0, 0.75, 1.5}), (RGBd{1.0, 0.25, -0.5}));
}

TEST(Cmyk, OfTheCornersOfTheCube) {
    EXPECT_EQ(cmyk_from_rgb({1.0, 0.0, 0.0}), (Cmyk{0.0, 1.0, 1.0, 0.0}));
    EXPECT_EQ(cmyk_from_rgb({1.0, 1.0, 0.0}), (Cmyk{0.0, 0.0, 1.0, 0.0}));
    EXPECT_EQ(cmyk_from_rgb({0.0, 0.0, 1.0}), (Cmyk{1.0, 1.0, 0.0, 0.0}));
    EXPECT_EQ(cmyk_from_rgb({1.0, 1.0, 1.0}), Cmyk{});
    EXPECT_EQ(cmyk_from_rgb({0.0, 0.0, 0.0}), (Cmyk{0.0, 0.0, 0.0, 1.0}));
}

// C = 0.875, M = 0.5, Y = 0.75, so K = 0.5 and the inks are (C - K) / (1 - K).
TEST(Cmyk, TakesAllGreyIntoBlack) {
    EXPECT_EQ(cmyk_from_rgb({0.125, 0.5, 0.25}), (Cmyk{0.75, 0.0, 0.5, 0.5}));
    EXPECT_EQ(cmyk_from_rgb({0.25, 0.25, 0.25}), (Cmyk{0.0, 0.0, 0.0, 0.75}));
}

TEST(Cmyk, WithAnyBlackGenerationIsRgb) {
    EXPECT_EQ(rgb_from_cmyk({0.75, 0.0, 0.5, 0.5}), (RGBd{0.125, 0.5, 0.25}));
    EXPECT_EQ(rgb_from_cmyk({0.875, 0.5, 0.75, 0.0}), (RGBd{0.125, 0.5, 0.25}));
}

TEST(Cmyk, OutsideTheCubeGoesThereAndBack) {
    for (const RGBd& rgb : {RGBd{1.5, 0.25, -0.5}, RGBd{-0.25, -0.5, -0.75}}) {
        const RGBd back = rgb_from_cmyk(cmyk_from_rgb(rgb));
        EXPECT_NEAR(back.r, rgb.r, 1e-15);
        EXPECT_NEAR(back.g, rgb.g, 1e-15);
        EXPECT_NEAR(back.b, rgb.b, 1e-15);
    }
    EXPECT_EQ(cmyk_from_rgb({1.5, 0.75, 0.0}), (Cmyk{0.0, 0.5, 1.0, -0.5}));
}

TEST(Cmyk, HasNoInksWhereTheGreatestIsZeroAboveANegative) {
    const Cmyk cmyk = cmyk_from_rgb({0.0, -0.5, 0.0});
    EXPECT_TRUE(std::isinf(cmyk.m));
    EXPECT_EQ(cmyk.c, 0.0);
    EXPECT_TRUE(std::isnan(rgb_from_cmyk(cmyk).g));
}

TEST(Cmyk, KeepsNan) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    for (const RGBd& rgb : {RGBd{kNan, 0.0, 1.0}, RGBd{0.0, kNan, 1.0}, RGBd{0.0, 1.0, kNan}}) {
        EXPECT_TRUE(std::isnan(cmyk_from_rgb(rgb).k));
    }
}

}  // namespace
}  // namespace emulsion
