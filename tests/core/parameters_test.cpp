#include "core/parameters.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(ParameterRange, EndsBelongWhenClosed) {
    constexpr ParameterRange kHalfOpen{0.0, 1.0, RangeEnd::open, RangeEnd::closed};
    EXPECT_FALSE(kHalfOpen.contains(0.0));
    EXPECT_TRUE(kHalfOpen.contains(std::numeric_limits<double>::denorm_min()));
    EXPECT_TRUE(kHalfOpen.contains(1.0));
    EXPECT_FALSE(kHalfOpen.contains(std::nextafter(1.0, 2.0)));
}

TEST(ParameterRange, HoldsNoNan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(ParameterRange{}.contains(nan));
    EXPECT_FALSE(kFinite.contains(nan));
    EXPECT_FALSE(kPositive.contains(nan));
}

TEST(ParameterRange, InfinityOnlyWhereSaid) {
    EXPECT_TRUE(kPositive.contains(kInfinity));
    EXPECT_FALSE(kPositiveFinite.contains(kInfinity));
    EXPECT_FALSE(kFinite.contains(-kInfinity));
    EXPECT_TRUE(ParameterRange{}.contains(-kInfinity));
}

TEST(ParameterRange, Text) {
    EXPECT_EQ(to_text(kPositive), "(0, inf]");
    EXPECT_EQ(to_text(kFinite), "(-inf, inf)");
    EXPECT_EQ(to_text(ParameterRange{1.0, 16.0}), "[1, 16]");
    EXPECT_EQ(to_text(ParameterRange{-0.5, 1e30}), "[-0.5, 1e+30]");
}

}  // namespace
}  // namespace emulsion
