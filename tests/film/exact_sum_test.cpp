#include "film/exact_sum.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

TEST(ExactSum, HoldsRepresentableNumbersExactly) {
    for (const double value : {0.0, 1.0, -1.0, 0x1.999ap-10, 1e9, -123456.75, 0x1p-44, 3 * 0x1p-44, 0x1p50,
                               0x1.fffffffffffffp50, -0x1.fffffffffffffp50, 0x1.fffffffffffffp8}) {
        EXPECT_EQ(ExactSum(value).value(), value);
    }
    EXPECT_EQ(ExactSum::kResolution, 0x1p-44);
    EXPECT_EQ(ExactSum::kLimit, 0x1p51);
    EXPECT_EQ(ExactWeightSum::kResolution, 0x1p-30);
    EXPECT_EQ(ExactWeightSum::kLimit, 0x1p33);
    EXPECT_EQ(ExactWeightSum(-0x1.fffffffffffffp32).value(), -0x1.fffffffffffffp32);
}

TEST(ExactSum, RoundsSmallNumbersToTheNearestMultiple) {
    EXPECT_EQ(ExactSum(0.75 * 0x1p-44).value(), 0x1p-44);
    EXPECT_EQ(ExactSum(-0.75 * 0x1p-44).value(), -0x1p-44);
    EXPECT_EQ(ExactSum(0.25 * 0x1p-44).value(), 0.0);
    EXPECT_EQ(ExactSum(2.5 * 0x1p-44).value(), 2 * 0x1p-44) << "ties go to even";
    EXPECT_EQ(ExactSum(3.5 * 0x1p-44).value(), 4 * 0x1p-44);
}

// In doubles 2^50 + 2^-44 - 2^50 is 0.
TEST(ExactSum, LosesNothingToMagnitude) {
    ExactSum sum;
    sum += ExactSum(0x1p50);
    sum += ExactSum(0x1p-44);
    sum += ExactSum(-0x1p50);
    EXPECT_EQ(sum.value(), 0x1p-44);
}

TEST(ExactSum, DoesNotDependOnOrder) {
    Pcg32 random(1);
    std::vector<double> terms;
    terms.reserve(1000);
    for (int i = 0; i < 1000; ++i) {
        terms.push_back(std::ldexp(static_cast<double>(random.next_float()) - 0.4, i % 84 - 40));
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

template <class Sum>
class FixedPointWidths : public ::testing::Test {};
using Widths = ::testing::Types<ExactSum, ExactWeightSum, FixedPointSum<128, 48>>;
TYPED_TEST_SUITE(FixedPointWidths, Widths);

TYPED_TEST(FixedPointWidths, SaturatesAndStaysThere) {
    using Sum = TypeParam;
    constexpr double kLimit = Sum::kLimit;
    EXPECT_TRUE(Sum(kLimit).is_saturated());
    EXPECT_TRUE(Sum(-1e300).is_saturated());
    EXPECT_TRUE(Sum(std::numeric_limits<double>::infinity()).is_saturated());
    EXPECT_TRUE(Sum(std::numeric_limits<double>::quiet_NaN()).is_saturated());
    EXPECT_FALSE(Sum(0.999 * kLimit).is_saturated());

    Sum sum(0.5 * kLimit);
    sum += Sum(0.25 * kLimit);
    EXPECT_FALSE(sum.is_saturated());
    EXPECT_EQ(sum.value(), 0.75 * kLimit) << "sums beyond the half are sums, too";
    sum += Sum(0.25 * kLimit);
    EXPECT_TRUE(sum.is_saturated());
    EXPECT_EQ(sum.value(), kLimit) << "not wrapped";
    sum += Sum(-0.5 * kLimit);
    EXPECT_TRUE(sum.is_saturated());
    EXPECT_EQ(sum.value(), kLimit);

    Sum low(-0.5 * kLimit);
    low += Sum(-0.75 * kLimit);
    EXPECT_TRUE(low.is_saturated());
    EXPECT_EQ(low.value(), -kLimit);
    low += Sum(kLimit);
    EXPECT_EQ(low.value(), -kLimit) << "the first end that it met";
}

TYPED_TEST(FixedPointWidths, TakesOverSaturation) {
    TypeParam sum(1.0);
    sum += TypeParam(-1e300);
    EXPECT_TRUE(sum.is_saturated());
    EXPECT_EQ(sum.value(), -TypeParam::kLimit);
}

TYPED_TEST(FixedPointWidths, SumsAreThoseOfIntegers) {
    Pcg32 random(2);
    TypeParam sum;
    Int128 expected = 0;
    for (int i = 0; i < 20000; ++i) {
        const Int128 units = static_cast<std::int32_t>(random.next()) * (Int128{1} << (random.next() % 20u));
        sum.add_units(units);
        expected += units;
        ASSERT_EQ(sum, TypeParam::from_units(expected));
    }
}

/// value * 2^fraction_bits, rounded once, by the library's own conversion.
template <class Sum>
Sum by_one_conversion(double value) {
    return Sum::from_units(static_cast<Int128>(std::nearbyint(std::ldexp(value, Sum::kFractionBits))));
}

// Two ways from a double: the quick one ends at 2^38 for sums of 96 bits, and at 2^22 for those of 128.
TEST(ExactSum, IsRoundedAlikeOnBothSidesOfTheQuickLimit) {
    Pcg32 random(5);
    using Wide = FixedPointSum<128, 60>;
    for (int i = 0; i < 20000; ++i) {
        const auto mantissa = static_cast<double>(random.next()) + static_cast<double>(random.next()) * 0x1p-32;
        for (const int exponent : {-90, -76, -60, -40, -12, 5, 6, 7, 12}) {
            const double value = std::ldexp(random.next() % 2u == 0 ? mantissa : -mantissa, exponent);
            ASSERT_EQ(ExactSum(value), by_one_conversion<ExactSum>(value)) << value;
            ASSERT_EQ(Wide(value), by_one_conversion<Wide>(value)) << value;
        }
    }
    // Halves of a unit go to the even one, on either side of 0 and beside a multiple of 2^32 units.
    for (const double units : {0.5, 1.5, -0.5, -1.5, 0x1p31 + 0.5, 0x1p32 - 0.5, 0x1p32 + 0.5, -0x1p32 + 0.5}) {
        const double value = std::ldexp(units, -ExactSum::kFractionBits);
        EXPECT_EQ(ExactSum(value), by_one_conversion<ExactSum>(value)) << units;
    }
}

}  // namespace
}  // namespace emulsion
