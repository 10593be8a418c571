#include "support/chi_square.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion::testing {
namespace {

// For whole a, Q(a, x) is a finite sum: the probability that a Poisson variable of mean x is below a.
TEST(UpperIncompleteGamma, IsThePoissonSumForWholeA) {
    for (const int a : {1, 2, 5, 20, 100}) {
        for (const double x : {1e-3, 0.5, 1.0, 3.0, 19.0, 25.0, 90.0, 130.0}) {
            double sum = 0.0;
            for (int k = 0; k < a; ++k) sum += std::exp(k * std::log(x) - x - std::lgamma(k + 1.0));
            EXPECT_NEAR(upper_incomplete_gamma(a, x), sum, 1e-12 + 1e-12 * sum) << a << ' ' << x;
        }
    }
}

TEST(UpperIncompleteGamma, IsTheErrorFunctionForOneHalf) {
    for (const double x : {1e-9, 0.1, 1.0, 1.4, 1.6, 5.0, 30.0}) {
        EXPECT_NEAR(upper_incomplete_gamma(0.5, x) / std::erfc(std::sqrt(x)), 1.0, 1e-12) << x;
    }
}

TEST(UpperIncompleteGamma, KnowsItsEnds) {
    EXPECT_EQ(upper_incomplete_gamma(3.0, 0.0), 1.0);
    EXPECT_EQ(upper_incomplete_gamma(3.0, std::numeric_limits<double>::infinity()), 0.0);
    EXPECT_THROW((void)upper_incomplete_gamma(0.0, 1.0), std::invalid_argument);
    EXPECT_THROW((void)upper_incomplete_gamma(1.0, -1.0), std::invalid_argument);
}

// Abramowitz & Stegun, table 26.8.
TEST(ChiSquareTail, GivesTheTabulatedPoints) {
    EXPECT_NEAR(chi_square_tail(3.84146, 1), 0.05, 1e-7);
    EXPECT_NEAR(chi_square_tail(18.3070, 10), 0.05, 1e-6);
    EXPECT_NEAR(chi_square_tail(135.807, 100), 0.01, 1e-6);
    EXPECT_NEAR(chi_square_tail(10.8276, 1), 0.001, 1e-7);
}

TEST(SidakLevel, IsThatOfAllTestsTogether) {
    EXPECT_DOUBLE_EQ(sidak_level(0.05, 1), 0.05);
    EXPECT_NEAR(1.0 - std::pow(1.0 - sidak_level(0.05, 20), 20), 0.05, 1e-14);
    EXPECT_NEAR(sidak_level(1e-9, 1000), 1e-12, 1e-20);
}

TEST(ChiSquareTest, SumsOverTheBins) {
    const std::vector<double> observed = {8, 12, 25, 15}, expected = {10, 10, 20, 20};
    const ChiSquareResult result = chi_square_test(observed, expected);
    EXPECT_DOUBLE_EQ(result.statistic, 0.4 + 0.4 + 1.25 + 1.25);
    EXPECT_EQ(result.degrees_of_freedom, 3.0);
    EXPECT_NEAR(result.p_value, 0.3476, 1e-4);
}

TEST(ChiSquareTest, PoolsSmallBins) {
    // 1 + 1 + 3 make one bin of five; the others stand alone.
    const std::vector<double> observed = {30, 3, 0, 4, 23}, expected = {30, 1, 1, 3, 25};
    const ChiSquareResult result = chi_square_test(observed, expected);
    EXPECT_EQ(result.degrees_of_freedom, 2.0);
    EXPECT_DOUBLE_EQ(result.statistic, 4.0 / 5.0 + 4.0 / 25.0);
    // Too few in all for any bin.
    EXPECT_EQ(chi_square_test(std::array{1.0, 2.0}, std::array{2.0, 1.0}).p_value, 1.0);
}

TEST(ChiSquareTest, NothingMayFallWhereNothingIsExpected) {
    EXPECT_EQ(chi_square_test(std::array{1.0, 999999.0, 1e6}, std::array{0.0, 1e6, 1e6}).p_value, 0.0);
    EXPECT_EQ(chi_square_test(std::array{0.0, 1e6, 1e6}, std::array{0.0, 1e6, 1e6}).p_value, 1.0);
}

TEST(ChiSquareTest, RefusesWhatAreNoCounts) {
    EXPECT_THROW((void)chi_square_test(std::array{1.0}, std::array{0.5, 0.5}), std::invalid_argument);
    EXPECT_THROW((void)chi_square_test(std::array{-1.0, 2.0}, std::array{0.5, 0.5}), std::invalid_argument);
    EXPECT_THROW((void)chi_square_test(std::array{1.0, 2.0}, std::array{2.0, 2.0}), std::invalid_argument);
    EXPECT_THROW((void)chi_square_test(std::array{1.0, std::nan("")}, std::array{1.0, 1.0}), std::invalid_argument);
}

// A right die is called wrong at the level that was asked for: of 4000 tests at 10%, 400 with a deviation of 19.
TEST(ChiSquareTest, RaisesFalseAlarmsAsOftenAsItSays) {
    Pcg32 random(1);
    int alarms = 0;
    for (int test = 0; test < 4000; ++test) {
        std::array<double, 6> observed{}, expected{};
        for (int i = 0; i < 600; ++i) observed[random.next() % 6] += 1.0;
        expected.fill(100.0);
        alarms += chi_square_test(observed, expected).p_value < 0.1 ? 1 : 0;
    }
    EXPECT_NEAR(alarms, 400, 4 * 19);
}

}  // namespace
}  // namespace emulsion::testing
