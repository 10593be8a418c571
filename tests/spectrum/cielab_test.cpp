#include "spectrum/cielab.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace emulsion
