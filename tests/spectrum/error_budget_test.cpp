#include "spectrum/error_budget.h"

#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using ::testing::HasSubstr;
using ::testing::Optional;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(ErrorBudget, IsReadFromItsText) {
    EXPECT_THAT(parse_auto("auto", "model"), Optional(ErrorBudget{1.0, 3.0}));
    EXPECT_THAT(parse_auto("Auto", "model"), Optional(ErrorBudget{}));
    EXPECT_THAT(parse_auto("auto:0.5", "model"), Optional(ErrorBudget{0.5, 1.5}));
    EXPECT_THAT(parse_auto("auto:0.5,7", "model"), Optional(ErrorBudget{0.5, 7.0}));
    EXPECT_THAT(parse_auto("auto:0,0", "model"), Optional(ErrorBudget{0.0, 0.0}));
    for (const char* other : {"", "rgb", "automatic", "autos:1"}) EXPECT_FALSE(parse_auto(other, "model"));
}

TEST(ErrorBudget, RefusesWhatIsNone) {
    for (const auto& [text, words] :
         {std::pair("auto:", "pixels auto: mean = \"\""), std::pair("auto:x", "pixels auto: mean = \"x\""),
          std::pair("auto:1,", "pixels auto: p99 = \"\""), std::pair("auto:1,2,3", "pixels auto: p99 = \"2,3\""),
          std::pair("auto:-1", "error budget: mean = -1: must be finite and at least 0"),
          std::pair("auto:1,-2", "error budget: p99 = -2"), std::pair("auto:inf", "mean")}) {
        try {
            (void)parse_auto(text, "pixels");
            ADD_FAILURE() << text;
        } catch (const std::invalid_argument& error) {
            EXPECT_THAT(error.what(), HasSubstr(words)) << text;
        }
    }
}

TEST(ErrorBudget, HoldsWhatIsWithinBothLimits) {
    constexpr ErrorBudget kBudget{1.0, 3.0};
    EXPECT_TRUE(is_within(1.0, 3.0, kBudget));
    EXPECT_FALSE(is_within(1.01, 3.0, kBudget));
    EXPECT_FALSE(is_within(1.0, 3.01, kBudget));
    EXPECT_FALSE(is_within(kNaN, 0.0, kBudget));
    EXPECT_TRUE(is_within(0.0, 0.0, {0.0, 0.0}));
}

}  // namespace
}  // namespace emulsion
