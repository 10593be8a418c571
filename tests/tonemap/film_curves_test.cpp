// hable, aces-fit, agx and khronos-neutral: a key of 1 and Ya = 1 make scaled luminance the luminance itself.

#include <cmath>

#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"

namespace emulsion {
namespace {

PreparedOperator curve_of(const ToneMapper& mapper) { return {mapper, row_of_greys({1.0f, 100.0f}), 1.0}; }

template <class T>
class FilmCurve : public testing::Test {};
using FilmCurves = testing::Types<HableFilmic, AcesFit, AgX, KhronosNeutral>;
TYPED_TEST_SUITE(FilmCurve, FilmCurves);

TYPED_TEST(FilmCurve, RisesFromZeroWithoutSteps) {
    const PreparedOperator displayed = curve_of(TypeParam{1.0f});
    EXPECT_EQ(displayed(0.0), 0.0);
    double previous = 0.0;
    for (double scaled = 1e-12; scaled < 1e12; scaled *= 1.001) {
        const double here = displayed(scaled);
        ASSERT_GE(here, previous * (1.0 - 1e-14)) << scaled;
        // No film curve here is steeper in ln over ln than 2.4.
        if (previous > 0.0) {
            ASSERT_LE(here, previous * std::pow(1.001, 2.4)) << scaled;
        }
        previous = here;
    }
}

// C1: slopes an ulp of 1e-5 apart differ by no more than a curve's bend.
TYPED_TEST(FilmCurve, HasNoCorners) {
    const PreparedOperator displayed = curve_of(TypeParam{1.0f});
    for (double scaled = 1e-6; scaled < 1e4; scaled *= 1.0001) {
        const double before = displayed.slope(scaled), after = displayed.slope(scaled * 1.0001);
        ASSERT_NEAR(before, after, 1e-3 * displayed.scale(scaled)) << scaled;
    }
}

TYPED_TEST(FilmCurve, KeyIsGivenToTheAdaptationLuminance) {
    const PreparedOperator one = curve_of(TypeParam{1.0f});
    const PreparedOperator metered(TypeParam{}, row_of_greys({1.0f, 100.0f}), 25.0);
    EXPECT_NEAR(metered(25.0), one(0.18), 1e-7);
    EXPECT_NEAR(metered(100.0), one(0.72), 1e-7);
}

// By hand: h(1) = 0.204/0.71 - 1/15, h(11.2) = 19.38/24.476 - 1/15; white = 5.6 of L is x = 11.2.
TEST(HableFilmic, HasThePublishedValues) {
    const PreparedOperator displayed = curve_of(HableFilmic{1.0f});
    const double white = 19.38 / 24.476 - 1.0 / 15.0;
    EXPECT_NEAR(displayed(0.5), (0.204 / 0.71 - 1.0 / 15.0) / white, 1e-7);
    EXPECT_NEAR(displayed(5.6), 1.0, 1e-7);
    EXPECT_NEAR(displayed.scale(0.0), 2.0 * (0.5 / 30.0) / 0.06 / white, 1e-6);
    EXPECT_NEAR(displayed(1e30), (14.0 / 15.0) / white, 1e-6);
    for (const float white_luminance : {0.01f, 1.0f, 50.0f, 1e9f}) {
        EXPECT_NEAR(curve_of(HableFilmic{1.0f, white_luminance})(double{white_luminance}), 1.0, 1e-14);
    }
}

// By hand: 2.54/3.16; 0.18 (0.4518 + 0.03) / (0.18 (0.4374 + 0.59) + 0.14); 0.08 L^2 - 0.56 L - 0.14 = 0 at white.
TEST(AcesFit, HasThePublishedValues) {
    const PreparedOperator displayed = curve_of(AcesFit{1.0f});
    EXPECT_NEAR(displayed(1.0), 2.54 / 3.16, 1e-14);
    EXPECT_NEAR(displayed(0.18), 0.086724 / 0.324932, 1e-14);
    EXPECT_NEAR(displayed((0.56 + std::sqrt(0.56 * 0.56 + 0.32 * 0.14)) / 0.16), 1.0, 1e-14);
    EXPECT_NEAR(displayed.scale(0.0), 0.03 / 0.14, 1e-14);
    EXPECT_NEAR(displayed(1e30), 2.51 / 2.43, 1e-12);
}

TEST(AgX, MiddleGreyAndWhiteAreWhereTheyBelong) {
    const PreparedOperator displayed = curve_of(AgX{1.0f});
    EXPECT_NEAR(displayed(0.18), std::pow(0.5, 2.2), 1e-14);
    EXPECT_NEAR(displayed(0.18 * std::pow(2.0, 6.5)), 1.0, 1e-13);
    EXPECT_GT(displayed(0.18 * std::pow(2.0, -10.0)), 0.0);
    EXPECT_LT(displayed(0.18 * std::pow(2.0, -10.0)), 3e-6);
    // Slope 2 in x at the pivot: d ln(y^2.2) / d ln(L) = 2.2 * 2 / (0.5 * 16.5 ln 2).
    EXPECT_NEAR(displayed.slope(0.18) * 0.18 / displayed(0.18), 4.4 / (8.25 * std::log(2.0)), 1e-6);
}

// The polynomial that most real-time implementations use (Wrensch, "Minimal AgX Implementation", 2023) was fitted to
// the same curve: within 0.0058 of it.
TEST(AgX, IsNearThePolynomialFitToIt) {
    const PreparedOperator displayed = curve_of(AgX{1.0f});
    for (double x = 0.13; x <= 1.0; x += 0.01) {
        const double polynomial =
            ((((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x) - 0.00232;
        const double encoded = std::pow(displayed(0.18 * std::pow(2.0, 16.5 * x - 10.0)), 1.0 / 2.2);
        EXPECT_NEAR(encoded, polynomial, 0.0058) << x;
    }
}

// By hand: 6.25 * 0.04^2; the join at 0.08; 0.5 - 0.04; the join at 0.8; c = 1 gives 1 - 0.0576/0.48.
TEST(KhronosNeutral, HasThePublishedValuesForGreys) {
    const PreparedOperator displayed = curve_of(KhronosNeutral{1.0f});
    EXPECT_NEAR(displayed(0.04), 0.01, 1e-15);
    EXPECT_NEAR(displayed(0.08), 0.04, 1e-15);
    EXPECT_NEAR(displayed(0.5), 0.46, 1e-15);
    EXPECT_NEAR(displayed(0.8), 0.76, 1e-15);
    EXPECT_NEAR(displayed(1.04), 0.88, 1e-15);
    EXPECT_NEAR(displayed.slope(0.0799), 1.0, 2e-3);
    EXPECT_NEAR(displayed.slope(0.0801), 1.0, 1e-8);
    EXPECT_NEAR(displayed.slope(0.7999), 1.0, 1e-8);
    EXPECT_NEAR(displayed.slope(0.8001), 1.0, 1e-3);
    EXPECT_NEAR(displayed(1e30), 1.0, 1e-12);
    EXPECT_EQ(displayed.scale(0.0), 0.0);
}

}  // namespace
}  // namespace emulsion
