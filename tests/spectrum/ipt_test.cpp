#include "spectrum/ipt.h"

#include <cmath>

#include <gtest/gtest.h>

#include "spectrum/chromaticity.h"

namespace emulsion {
namespace {

// The example of the "colour" package (Mansencal et al.) for XYZ_to_IPT; XYZ has 8 decimals, times a slope of up to 20.
TEST(Ipt, OfAPublishedExample) {
    const Ipt ipt = ipt_from_xyz({0.20654008, 0.12197225, 0.05136952});
    EXPECT_NEAR(ipt.i, 0.38426191, 1e-7);
    EXPECT_NEAR(ipt.p, 0.38487306, 1e-7);
    EXPECT_NEAR(ipt.t, 0.18886838, 1e-7);
}

TEST(Ipt, OfD65IsGreyToTheDigitsOfItsMatrices) {
    const Ipt white = ipt_from_xyz(xyz_of(Chromaticity{0.3127, 0.329}));
    EXPECT_NEAR(white.i, 1.0, 1e-4);
    EXPECT_LT(std::hypot(white.p, white.t), 5e-4);
}

TEST(Ipt, ScalesWithThePowerAlsoBelowZero) {
    const Ipt one = ipt_from_xyz({0.2, 0.3, 0.1}), minus_two = ipt_from_xyz({-0.4, -0.6, -0.2});
    const double scale = -std::pow(2.0, 0.43);
    EXPECT_NEAR(minus_two.i, scale * one.i, 1e-15);
    EXPECT_NEAR(minus_two.p, scale * one.p, 1e-14);
    EXPECT_NEAR(minus_two.t, scale * one.t, 1e-15);
}

TEST(Ipt, IsUndoneToRoundingAlsoForNegativeCones) {
    for (const XYZd& xyz : {XYZd{1.0, 0.0, 0.0}, XYZd{0.0, 0.0, 1.0}, XYZd{0.3, -0.2, 1.4}, XYZd{}}) {
        const XYZd back = xyz_from_ipt(ipt_from_xyz(xyz));
        EXPECT_NEAR(back.x, xyz.x, 1e-14);
        EXPECT_NEAR(back.y, xyz.y, 1e-14);
        EXPECT_NEAR(back.z, xyz.z, 1e-14);
    }
}

}  // namespace
}  // namespace emulsion
