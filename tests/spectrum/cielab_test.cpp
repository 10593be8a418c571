#include "spectrum/cielab.h"

#include <gtest/gtest.h>

#include "spectrum/chromaticity.h"

namespace emulsion {
namespace {

constexpr XYZd kWhite = {95.047, 100.0, 108.883};

TEST(Lab, WhiteAndBlack) {
    EXPECT_EQ(lab_from_xyz(kWhite, kWhite), (Lab{100.0, 0.0, 0.0}));
    const Lab black = lab_from_xyz({}, kWhite);
    EXPECT_NEAR(black.l, 0.0, 1e-14);
    EXPECT_EQ(black.a, 0.0);
    EXPECT_EQ(black.b, 0.0);
}

TEST(Lab, EighteenPerCentGreyHasLightness49_5) {
    const Lab grey = lab_from_xyz(0.18 * kWhite, kWhite);
    EXPECT_NEAR(grey.l, 49.4961, 1e-4);
    EXPECT_NEAR(grey.a, 0.0, 1e-12);
    EXPECT_NEAR(grey.b, 0.0, 1e-12);
}

TEST(Lab, HasALinearToe) {
    // L* = (29/3)^3 Y/Yn below (6/29)^3: the bare cube root would give 116 * 0.1 - 16 = -4.4 here.
    EXPECT_NEAR(lab_from_xyz(0.001 * kWhite, kWhite).l, 0.9032963, 1e-7);
    // Both pieces meet.
    constexpr double kKnee = 216.0 / 24389.0;
    EXPECT_NEAR(lab_from_xyz((kKnee - 1e-9) * kWhite, kWhite).l, lab_from_xyz((kKnee + 1e-9) * kWhite, kWhite).l, 4e-6);
}

TEST(Lab, OfSrgbRed) {
    const Lab red = lab_from_xyz({41.2391, 21.2639, 1.9331}, {95.0456, 100.0, 108.9058});
    EXPECT_NEAR(red.l, 53.24, 0.01);
    EXPECT_NEAR(red.a, 80.09, 0.01);
    EXPECT_NEAR(red.b, 67.20, 0.01);
}

// The example of the "colour" package (Mansencal et al.) for XYZ_to_Lab; XYZ has 8 decimals, times a slope of up to
// 1e3.
TEST(Lab, OfAPublishedExample) {
    const Lab lab = lab_from_xyz({0.20654008, 0.12197225, 0.05136952}, xyz_of(Chromaticity{0.3127, 0.329}));
    EXPECT_NEAR(lab.l, 41.52787529, 5e-6);
    EXPECT_NEAR(lab.a, 52.63858304, 5e-6);
    EXPECT_NEAR(lab.b, 26.92317922, 5e-6);
}

TEST(Lab, OfBlackHasLightnessZeroExactly) { EXPECT_EQ(lab_from_xyz({}, kWhite).l, 0.0); }

TEST(Lab, TheToeTakesNegativeValues) {
    const XYZd negative = {-10.0, -20.0, 30.0};
    const Lab lab = lab_from_xyz(negative, kWhite);
    EXPECT_DOUBLE_EQ(lab.l, -0.2 * 24389.0 / 27.0);  // (29/3)^3 Y/Yn
    const XYZd back = xyz_from_lab(lab, kWhite);
    EXPECT_NEAR(back.x, negative.x, 1e-12);
    EXPECT_NEAR(back.y, negative.y, 1e-12);
    EXPECT_NEAR(back.z, negative.z, 1e-12);
}

TEST(Lab, LightnessAndItsInverseMeetAtTheKnee) {
    constexpr double kKnee = 216.0 / 24389.0;  // (6/29)^3, where L* = 8
    EXPECT_NEAR(cie_lightness(kKnee), 8.0, 1e-14);
    EXPECT_NEAR(cie_lightness(kKnee * (1.0 + 1e-12)), 8.0, 1e-11);
    EXPECT_NEAR(relative_luminance_of(8.0), kKnee, 1e-17);
    EXPECT_NEAR(relative_luminance_of(8.0 + 1e-12), kKnee, 1e-14);
}

TEST(Lab, AsChromaAndHue) {
    EXPECT_EQ(lch_from_lab({50.0, -3.0, -4.0}).chroma, 5.0);
    EXPECT_DOUBLE_EQ(lch_from_lab({50.0, -3.0, -4.0}).hue_deg, 233.13010235415598);  // 180 + atan(4/3)
    const Lab back = lab_from_lch({50.0, 5.0, 233.13010235415598});
    EXPECT_NEAR(back.a, -3.0, 1e-14);
    EXPECT_NEAR(back.b, -4.0, 1e-14);
}

}  // namespace
}  // namespace emulsion
