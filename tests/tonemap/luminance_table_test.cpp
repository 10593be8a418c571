#include "tonemap/luminance_table.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// The largest relative error over [1e-20, 1e20].
double largest_error(double (*function)(double)) {
    const LuminanceTable table(function, 1e-20, 1e20, 1);
    double largest = 0.0;
    for (double x = 1e-20; x < 0.99e20; x *= 1.00037) {
        const auto single = static_cast<float>(x);
        const double exact = function(double{single});
        largest = std::max(largest, std::abs(double{table(single)} - exact) / std::abs(exact));
    }
    return largest;
}

constexpr double kRounding = 2.5e-7;  // of value, slope, product and sum in single precision

// |x^2 f'' / f| of x^p is |p (p - 1)|: 2, 1/4, 6, and 0 of what is linear. The bound is nearly reached, at the lower
// end of an octave, where h = x / 64.
TEST(LuminanceTable, ErrorOfPowersIsWithinItsBound) {
    constexpr double kBound = 1.0 / (8.0 * 64.0 * 64.0);  // 3.05e-5
    EXPECT_LE(largest_error([](double x) { return 1.0 / x; }), 2.0 * kBound + kRounding);
    EXPECT_GE(largest_error([](double x) { return 1.0 / x; }), 1.8 * kBound);
    EXPECT_LE(largest_error([](double x) { return std::sqrt(x); }), 0.25 * kBound + kRounding);
    EXPECT_LE(largest_error([](double x) { return x; }), kRounding);
    EXPECT_LE(largest_error([](double) { return 3.7; }), kRounding);
}

TEST(LuminanceTable, KnotsAreExact) {
    const LuminanceTable table([](double x) { return 1.0 / (1.0 + x); }, 1e-3, 1e3, 1);
    for (const float knot : {0.25f, 1.0f, 1.0f + 1.0f / 64.0f, 1.5f, 2.0f + 1.0f / 32.0f, 768.0f}) {
        EXPECT_FLOAT_EQ(table(knot), 1.0f / (1.0f + knot));
    }
}

TEST(LuminanceTable, KeepsItsEnds) {
    const LuminanceTable table([](double x) { return x; }, 2.0, 10.0, 1);
    EXPECT_FLOAT_EQ(table(2.0f), 2.0f);
    EXPECT_FLOAT_EQ(table(0.0f), 2.0f);
    EXPECT_FLOAT_EQ(table(1e-40f), 2.0f);
    EXPECT_FLOAT_EQ(table(10.0f), 10.0f);
    EXPECT_FLOAT_EQ(table(1e30f), 10.0f);
    EXPECT_FLOAT_EQ(table(kInf), 10.0f);
    EXPECT_FLOAT_EQ(table(kNan), 10.0f);
    EXPECT_FLOAT_EQ(table(-1.0f), 10.0f);
}

TEST(LuminanceTable, OnePointIsARange) {
    const LuminanceTable table([](double x) { return 2.0 * x; }, 3.0, 3.0, 1);
    EXPECT_FLOAT_EQ(table(3.0f), 6.0f);
    EXPECT_FLOAT_EQ(table(100.0f), 6.0f);
}

TEST(LuminanceTable, AllFloatsAreARange) {
    const LuminanceTable table([](double x) { return 1.0 / (1.0 + x); }, 0.0, 0x1p128, 1);
    EXPECT_FLOAT_EQ(table(1.0f), 0.5f);
    EXPECT_NEAR(table(1e20f), 1e-20f, 1e-20f * 6.2e-5f);
    EXPECT_FLOAT_EQ(table(1e-30f), 1.0f);
}

TEST(LuminanceTable, HasNoValueWhereSinglePrecisionDoesNotReach) {
    const LuminanceTable steep([](double x) { return x; }, 0.0, 0x1p128, 1);
    EXPECT_TRUE(std::isnan(steep(1e-40f)));     // denormal x
    EXPECT_TRUE(std::isnan(steep(0x1p-100f)));  // value below 2^-90
    EXPECT_TRUE(std::isnan(steep(0x1p-91f)));
    EXPECT_FLOAT_EQ(steep(0x1p-88f), 0x1p-88f);
    EXPECT_FLOAT_EQ(steep(0x1p125f), 0x1p125f);
    EXPECT_TRUE(std::isnan(steep(0x1.8p126f)));  // value above 2^126
    const LuminanceTable zero([](double) { return 0.0; }, 1.0, 2.0, 1);
    EXPECT_EQ(zero(1.5f), 0.0f);
    const LuminanceTable negative([](double) { return -1.0; }, 1.0, 2.0, 1);
    EXPECT_TRUE(std::isnan(negative(1.5f)));
}

// At the knots: those about 3 and 10 are 3 and 10 themselves, and the next ones after them.
TEST(LuminanceTable, KnowsItsLeastAndItsMost) {
    const LuminanceTable falling([](double x) { return 1.0 / x; }, 3.0, 10.0, 1);
    EXPECT_NEAR(falling.most_value(), 1.0 / 3.0, 1.0 / 3.0 / 64.0);
    EXPECT_NEAR(falling.least_value(), 0.1, 0.1 / 64.0);
    const LuminanceTable humped([](double x) { return std::exp(-(x - 5.0) * (x - 5.0)); }, 3.0, 10.0, 1);
    EXPECT_NEAR(humped.most_value(), 1.0, 1e-12);
}

TEST(LuminanceTable, IsTheSameForEveryNumberOfThreads) {
    const auto function = [](double x) { return std::sqrt(x) / (1.0 + x); };
    const LuminanceTable one(function, 1e-20, 1e20, 1), three(function, 1e-20, 1e20, 3);
    for (float x = 1e-20f; x < 1e20f; x *= 1.0037f) ASSERT_EQ(one(x), three(x)) << x;
}

}  // namespace
}  // namespace emulsion
