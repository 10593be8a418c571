#include "spectrum/xyy.h"

#include <cmath>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

constexpr XYZd kWhite = {0.95, 1.0, 1.05};

TEST(Xyy, DividesByTheSum) {
    EXPECT_EQ(xyy_from_xyz({1.0, 2.0, 5.0}, kWhite), (Xyy{0.125, 0.25, 2.0}));
    EXPECT_EQ(xyz_from_xyy({0.125, 0.25, 2.0}), (XYZd{1.0, 2.0, 5.0}));
}

TEST(Xyy, BlackHasTheChromaticityOfTheWhite) {
    const Xyy black = xyy_from_xyz({}, kWhite);
    EXPECT_DOUBLE_EQ(black.x, 0.95 / 3.0);
    EXPECT_DOUBLE_EQ(black.y, 1.0 / 3.0);
    EXPECT_EQ(black.luminance, 0.0);
    EXPECT_EQ(xyz_from_xyy(black), XYZd{});
}

TEST(Xyy, OfColoursWithoutLuminanceDoesNotComeBack) {
    const Xyy dark = xyy_from_xyz({1.0, 0.0, 3.0}, kWhite);
    EXPECT_EQ(dark, (Xyy{0.25, 0.0, 0.0}));
    EXPECT_FALSE(std::isfinite(xyz_from_xyy(dark).x));
    // X + Y + Z = 0, but not black.
    EXPECT_FALSE(std::isfinite(xyy_from_xyz({1.0, 1.0, -2.0}, kWhite).x));
}

}  // namespace
}  // namespace emulsion
