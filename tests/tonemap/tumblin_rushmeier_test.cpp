#include "tonemap/tumblin_rushmeier.h"

#include <cmath>

#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"

namespace emulsion {
namespace {

TEST(StevensExponent, HasThePapersValues) {
    EXPECT_NEAR(stevens_exponent(1.0), 1.855, 5e-6);
    EXPECT_NEAR(stevens_exponent(10.0), 2.255, 1e-6);
    EXPECT_NEAR(stevens_exponent(100.0), 2.655, 1e-7);
    EXPECT_EQ(stevens_exponent(1e6), 2.655);
    EXPECT_EQ(stevens_exponent(0.0), 0.0);
    EXPECT_NEAR(stevens_exponent(1e-4), 0.290962, 1e-6);  // 1.855 + 0.4 log10(1.23e-4)
}

// Lda = 100/10; g = 2.655/2.255 = 1.177384; m Lda / 100 = 10^0.177384 / 10.
TEST(TumblinRushmeier, HasThePapersValues) {
    const PreparedOperator displayed(TumblinRushmeier{100.0f, 100.0f}, row_of_greys({50.0f, 200.0f}), 100.0);
    const double power = 2.655 / 2.255;
    EXPECT_NEAR(displayed(100.0), std::pow(10.0, power - 2.0), 1e-6);
    EXPECT_NEAR(displayed(200.0) / displayed(100.0), std::pow(2.0, power), 1e-6);
}

TEST(TumblinRushmeier, AdaptedAlikeItIsLinear) {
    const PreparedOperator displayed(TumblinRushmeier{100.0f, 25.0f}, row_of_greys({5.0f, 80.0f}), 20.0);
    for (const double luminance : {1e-6, 0.5, 20.0, 80.0}) {
        EXPECT_NEAR(displayed(luminance) / (luminance / 100.0), 1.0, 1e-9) << luminance;
    }
}

// Of a dim scene g is less than 1, and x^(g - 1) infinite at 0.
TEST(TumblinRushmeier, DarkEndIsLinearAndFinite) {
    const PreparedOperator displayed(TumblinRushmeier{}, row_of_greys({1e-3f, 1e-1f}), 1e-2);
    const double at_zero = displayed.scale(0.0);
    EXPECT_TRUE(std::isfinite(at_zero));
    EXPECT_NEAR(displayed.scale(1e-9) / at_zero, 1.0, 1e-5);
    const double power = stevens_exponent(1e-2) / stevens_exponent(100.0 / std::sqrt(50.0));
    EXPECT_NEAR(displayed(1e-3) / displayed(1e-2), std::pow(0.1, power), 1e-6);
}

}  // namespace
}  // namespace emulsion
