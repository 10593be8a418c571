// The rule by which high dynamic range comes to CIELAB and to ICtCp.

#include "spectrum/viewing_conditions.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/chromaticity.h"
#include "spectrum/pq.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const ViewingConditions kViewing{.white = default_white(cie_1931_2deg()), .white_luminance_cdm2 = 250.0};

XYZd grey(double luminance_cdm2) { return luminance_cdm2 * kViewing.white; }

TEST(ViewingConditions, TheLogAverageIsMiddleGrey) {
    const double white = white_luminance_of_log_average(36.0);
    EXPECT_DOUBLE_EQ(white, 200.0);
    const Lab lab = lab_as_viewed(36.0 * kViewing.white, {kViewing.white, white});
    EXPECT_NEAR(lab.l, 116.0 * std::cbrt(0.18) - 16.0, 1e-12);  // 49.5
    EXPECT_NEAR(std::hypot(lab.a, lab.b), 0.0, 1e-12);
}

TEST(ViewingConditions, WhatIsBrighterThanWhiteHasItsLuminanceAndKeepsItsChromaticity) {
    for (const double luminance : {250.0, 251.0, 1e6, 1e30}) {
        const Lab white = lab_as_viewed(grey(luminance), kViewing);
        EXPECT_NEAR(white.l, 100.0, 1e-9) << luminance;
        EXPECT_NEAR(std::hypot(white.a, white.b), 0.0, 1e-9) << luminance;
    }
    const XYZd orange = xyz_of({0.5, 0.4}, 250.0);
    const Lab at_white = lab_as_viewed(orange, kViewing), above = lab_as_viewed(400.0 * orange, kViewing);
    EXPECT_NEAR(above.l, at_white.l, 1e-9);
    EXPECT_NEAR(above.a, at_white.a, 1e-9);
    EXPECT_NEAR(above.b, at_white.b, 1e-9);
    EXPECT_GT(at_white.b, 50.0);
}

TEST(ViewingConditions, LightBelowNothingIsNone) {
    EXPECT_EQ(lab_as_viewed({-3.0, -50.0, -1.0}, kViewing), lab_as_viewed({}, kViewing));
    EXPECT_EQ(lab_as_viewed({}, kViewing).l, 0.0);
    EXPECT_EQ(lab_as_viewed({-3.0, 50.0, 20.0}, kViewing), lab_as_viewed({0.0, 50.0, 20.0}, kViewing));
    EXPECT_EQ(ictcp_as_viewed({-3.0, -50.0, -1.0}, kViewing), ictcp_as_viewed({}, kViewing));
}

TEST(ViewingConditions, OfIctcpWhiteIsShownAt203AndThePeakIs10000) {
    const ICtCp white = ictcp_as_viewed(grey(250.0), kViewing);
    EXPECT_NEAR(white.i, encode(PqTransfer{}, 0.0203), 1e-12);  // 0.5807
    EXPECT_NEAR(white.ct, 0.0, 1e-6);
    EXPECT_NEAR(white.cp, 0.0, 1e-6);
    EXPECT_NEAR(ictcp_as_viewed(grey(250.0 / 203.0 * 1e4), kViewing).i, 1.0, 1e-12);
    EXPECT_NEAR(ictcp_as_viewed(grey(1e9), kViewing).i, 1.0, 1e-12);
}

TEST(ViewingConditions, TheUnitOfLuminanceMakesNoDifference) {
    for (const double unit : {1e-12, 1e-3, 1e7}) {
        const ViewingConditions other{kViewing.white, unit * kViewing.white_luminance_cdm2};
        const XYZd color{30.0, 25.0, 11.0};
        const Lab here = lab_as_viewed(color, kViewing), there = lab_as_viewed(unit * color, other);
        EXPECT_NEAR(here.l, there.l, 1e-11);
        EXPECT_NEAR(here.a, there.a, 1e-11);
        EXPECT_NEAR(here.b, there.b, 1e-11);
    }
}

TEST(ViewingConditions, NaNStaysNaN) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(lab_as_viewed({1.0, kNaN, 1.0}, kViewing).l));
    EXPECT_TRUE(std::isnan(ictcp_as_viewed({1.0, kNaN, 1.0}, kViewing).i));
}

// CIE 15:2004, table T.3: D65 for 1964 has x 0.3138, y 0.3310.
TEST(ViewingConditions, TheDefaultWhiteIsD65OfTheObserver) {
    const Chromaticity of_1931 = chromaticity_of(default_white(cie_1931_2deg()));
    EXPECT_NEAR(of_1931.x, 0.3127, 1e-12);
    EXPECT_NEAR(of_1931.y, 0.3290, 1e-12);
    const XYZd wide = default_white(cie_1964_10deg());
    EXPECT_DOUBLE_EQ(wide.y, 1.0);
    EXPECT_NEAR(chromaticity_of(wide).x, 0.3138, 1e-4);
    EXPECT_NEAR(chromaticity_of(wide).y, 0.3310, 1e-4);
}

TEST(ViewingConditions, OtherWhitesAreRefused) {
    EXPECT_NO_THROW(validate(kViewing));
    EXPECT_THAT(
        [] {
            validate({kViewing.white, 0.0});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("white luminance 0 cd/m^2: must be in [1e-30, 1e30]")));
    EXPECT_THROW(validate({kViewing.white, std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
    EXPECT_THAT(
        [] {
            validate({{0.9, 2.0, 1.0}, 1.0});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("expected finite X, Z > 0 and Y = 1")));
}

}  // namespace
}  // namespace emulsion
