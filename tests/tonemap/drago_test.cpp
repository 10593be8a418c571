#include "tonemap/drago.h"

#include <cmath>

#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"

namespace emulsion {
namespace {

// Ya = 10, Lmax = 100/10. By hand, of L = 1: log10(11) = 1.0413927, 0.1^0.2344653 = 0.5828204,
// ln(2 + 8 * 0.5828204) = 1.8965043; ln 2 / (1.0413927 * 1.8965043) = 0.3509596.
TEST(Drago, HasThePapersValues) {
    const PreparedOperator displayed(Drago{}, row_of_greys({1.0f, 100.0f}), 10.0);
    EXPECT_NEAR(displayed(100.0), 1.0, 1e-14);
    EXPECT_NEAR(displayed(10.0), 0.3509596, 1e-7);
    EXPECT_EQ(displayed(0.0), 0.0);
}

// A bias of 1/2 makes the base 2 + 8 L / Lmax, of 1 everywhere 10; both scale L by (0.15 + b)^5.
TEST(Drago, BiasBendsTheBase) {
    const Image<XYZ> scene = row_of_greys({1.0f, 20.0f});
    const double half = std::pow(0.65, 5), one = std::pow(1.15, 5);
    EXPECT_NEAR(PreparedOperator(Drago{0.5f}, scene, 10.0)(2.5),
                std::log(1.0 + 0.25 * half) / (std::log10(1.0 + 2.0 * half) * std::log(3.0)), 1e-7);
    EXPECT_NEAR(PreparedOperator(Drago{1.0f}, scene, 10.0)(5.0),
                std::log10(1.0 + 0.5 * one) / std::log10(1.0 + 2.0 * one), 1e-7);
}

TEST(Drago, PeakIsBrightness) {
    const Image<XYZ> scene = row_of_greys({1.0f, 100.0f});
    const PreparedOperator once(Drago{0.85f, 100.0f}, scene, 10.0), twice(Drago{0.85f, 200.0f}, scene, 10.0);
    for (const double luminance : {0.1, 10.0, 100.0, 1e4}) EXPECT_DOUBLE_EQ(twice(luminance), 2.0 * once(luminance));
}

// Ld / L at 0 is 1 / (log10(1 + Lmax) ln 2); a bias of 0.85 in single precision scales it by 1 + 1.2e-7.
TEST(Drago, DarkEndHasTheLimitOfTheFormula) {
    const PreparedOperator displayed(Drago{}, row_of_greys({1.0f, 100.0f}), 10.0);
    const double limit = 0.1 / (std::log10(11.0) * std::log(2.0));
    EXPECT_NEAR(displayed.scale(0.0) / limit, 1.0, 1.3e-7);
    EXPECT_NEAR(displayed.scale(1e-60) / limit, 1.0, 1.3e-7);
    EXPECT_NEAR(displayed.scale(0.9999e-7) / displayed.scale(1.0001e-7), 1.0, 1e-4);
}

TEST(Drago, GoesOnAlongItsTangentPastTheLargestLuminance) {
    const PreparedOperator displayed(Drago{}, row_of_greys({1.0f, 100.0f}), 10.0);
    EXPECT_NEAR(displayed.slope(99.99) / displayed.slope(100.01), 1.0, 5e-4);
    EXPECT_GT(displayed(1e6), displayed(1e5));
    EXPECT_GT(displayed(1e5), 1.0);
}

// The formula itself falls towards the largest luminance where that is more than 9e4 times Ya.
TEST(Drago, RisesHoweverLargeTheRange) {
    for (const float bias : {0.3f, 0.7f, 0.85f, 1.0f}) {
        for (const float most : {1e-3f, 1.0f, 1e3f, 1e6f, 1e12f, 1e30f}) {
            const PreparedOperator displayed(Drago{bias}, row_of_greys({1e-4f, most}), 1.0);
            EXPECT_NEAR(displayed(double{most}), 1.0, 1e-12);
            double previous = 0.0;
            for (double luminance = 1e-6; luminance < 1e33; luminance *= 1.07) {
                const double here = displayed(luminance);
                ASSERT_GE(here, previous * (1.0 - 1e-14)) << bias << ", " << most << ", " << luminance;
                previous = here;
            }
        }
    }
}

}  // namespace
}  // namespace emulsion
