#include "support/kolmogorov_smirnov.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion::testing {
namespace {

/// `count` numbers of the normal distribution, by Box and Muller's transform.
std::vector<double> normal_numbers(int count, Pcg32& random, double mean = 0.0, double deviation = 1.0) {
    std::vector<double> numbers;
    for (int i = 0; i < count; ++i) {
        const double radius = std::sqrt(-2.0 * std::log1p(-static_cast<double>(random.next_float())));
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(random.next_float());
        numbers.push_back(mean + deviation * radius * std::cos(angle));
    }
    return numbers;
}

TEST(NormalCdf, GivesTheTabulatedPoints) {
    EXPECT_DOUBLE_EQ(normal_cdf(0.0), 0.5);
    EXPECT_NEAR(normal_cdf(1.959963985), 0.975, 1e-10);
    EXPECT_NEAR(normal_cdf(-3.090232306), 0.001, 1e-12);
}

// Miller, "Table of Percentage Points of Kolmogorov Statistics", JASA 51, 1956; the limit for many numbers: Smirnov
// 1948.
TEST(KolmogorovTail, GivesTheTabulatedPoints) {
    EXPECT_NEAR(kolmogorov_tail(0.29408, 20), 0.05, 0.001);
    EXPECT_NEAR(kolmogorov_tail(0.35241, 20), 0.01, 0.0003);
    EXPECT_NEAR(kolmogorov_tail(0.13403, 100), 0.05, 0.001);
    EXPECT_NEAR(kolmogorov_tail(0.16081, 100), 0.01, 0.0003);
    EXPECT_NEAR(kolmogorov_tail(1.35810e-6, 1e12), 0.05, 1e-6);
    EXPECT_NEAR(kolmogorov_tail(1.94947e-6, 1e12), 0.001, 1e-7);
    EXPECT_EQ(kolmogorov_tail(0.0, 100), 1.0);
    EXPECT_NEAR(kolmogorov_tail(1.0, 1000), 0.0, 1e-300);
}

TEST(NormalityTest, MeasuresTheLargestDistance) {
    EXPECT_DOUBLE_EQ(normality_test({0.0}).statistic, 0.5);
    EXPECT_NEAR(normality_test({-1.0, 1.0}).statistic, normal_cdf(1.0) - 0.5, 1e-15);
    EXPECT_DOUBLE_EQ(normality_test({10.0, 11.0, 12.0}).statistic, 1.0);
    EXPECT_THROW((void)normality_test({}), std::invalid_argument);
}

// Of 2000 tests at 10%, 200 with a deviation of 13.
TEST(NormalityTest, RaisesFalseAlarmsAsOftenAsItSays) {
    Pcg32 random(1);
    int alarms = 0;
    for (int test = 0; test < 2000; ++test) alarms += normality_test(normal_numbers(100, random)).p_value < 0.1 ? 1 : 0;
    EXPECT_NEAR(alarms, 200, 4 * 13);
}

TEST(NormalityTest, NoticesAShiftAndAWrongWidth) {
    Pcg32 random(2);
    EXPECT_GT(normality_test(normal_numbers(1000, random)).p_value, 1e-3);
    EXPECT_LT(normality_test(normal_numbers(1000, random, 0.2)).p_value, 1e-3);
    EXPECT_LT(normality_test(normal_numbers(1000, random, 0.0, 1.3)).p_value, 1e-3);
    EXPECT_LT(normality_test(normal_numbers(1000, random, 0.0, 0.75)).p_value, 1e-3);
}

}  // namespace
}  // namespace emulsion::testing
