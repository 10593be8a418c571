#include "film/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

TEST(ExactSum, HoldsRepresentableNumbersExactly) {
    for (const double value : {0.0, 1.0, -1.0, 0.1, 1e9, -123456.789, 0x1p-64, 3 * 0x1p-64, 0x1p62,
                               0x1.fffffffffffffp62, -0x1.fffffffffffffp62, 0x1.fffffffffffffp-12}) {
        EXPECT_EQ(ExactSum(value).value(), value);
    }
}

TEST(ExactSum, RoundsSmallNumbersToTheNearestMultiple) {
    EXPECT_EQ(ExactSum(0.75 * 0x1p-64).value(), 0x1p-64);
    EXPECT_EQ(ExactSum(-0.75 * 0x1p-64).value(), -0x1p-64);
    EXPECT_EQ(ExactSum(0.25 * 0x1p-64).value(), 0.0);
    EXPECT_EQ(ExactSum(2.5 * 0x1p-64).value(), 2 * 0x1p-64) << "ties go to even";
    EXPECT_EQ(ExactSum(3.5 * 0x1p-64).value(), 4 * 0x1p-64);
}

// In doubles 2^62 + 2^-64 - 2^62 is 0.
TEST(ExactSum, LosesNothingToMagnitude) {
    ExactSum sum;
    sum += ExactSum(0x1p62);
    sum += ExactSum(0x1p-64);
    sum += ExactSum(-0x1p62);
    EXPECT_EQ(sum.value(), 0x1p-64);
}

TEST(ExactSum, DoesNotDependOnOrder) {
    Pcg32 random(1);
    std::vector<double> terms;
    terms.reserve(1000);
    for (int i = 0; i < 1000; ++i) {
        terms.push_back(std::ldexp(static_cast<double>(random.next_float()) - 0.4, i % 120 - 60));
    }
    ExactSum forwards;
    for (const double term : terms) forwards += ExactSum(term);
    std::mt19937 shuffler(1);
    bool doubles_differ = false;
    const double plain = std::accumulate(terms.begin(), terms.end(), 0.0);
    for (int i = 0; i < 100; ++i) {
        std::shuffle(terms.begin(), terms.end(), shuffler);
        ExactSum sum;
        for (const double term : terms) sum += ExactSum(term);
        EXPECT_EQ(sum, forwards);
        doubles_differ = doubles_differ || std::accumulate(terms.begin(), terms.end(), 0.0) != plain;
    }
    EXPECT_TRUE(doubles_differ) << "the terms are too tame for this test to say anything";
}

TEST(ExactSum, SaturatesAndStaysThere) {
    EXPECT_TRUE(ExactSum(0x1p63).is_saturated());
    EXPECT_TRUE(ExactSum(-1e300).is_saturated());
    EXPECT_TRUE(ExactSum(std::numeric_limits<double>::infinity()).is_saturated());
    EXPECT_TRUE(ExactSum(std::numeric_limits<double>::quiet_NaN()).is_saturated());
    EXPECT_FALSE(ExactSum(0x1.fffffffffffffp62).is_saturated());

    ExactSum sum(0x1p62);
    sum += ExactSum(0x1p62);
    EXPECT_TRUE(sum.is_saturated());
    EXPECT_EQ(sum.value(), 0x1p63) << "not wrapped";
    sum += ExactSum(-0x1p62);
    EXPECT_TRUE(sum.is_saturated());
    EXPECT_EQ(sum.value(), 0x1p63);

    ExactSum low(-0x1p62);
    low += ExactSum(-0x1.8p62);
    EXPECT_TRUE(low.is_saturated());
    EXPECT_EQ(low.value(), -0x1p63);
}

TEST(ExactSum, TakesOverSaturation) {
    ExactSum sum(1.0);
    sum += ExactSum(-1e30);
    EXPECT_TRUE(sum.is_saturated());
    EXPECT_EQ(sum.value(), -0x1p63);
}

}  // namespace
}  // namespace emulsion
