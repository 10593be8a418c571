#include "cli/number_list.h"

#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion::cli {
namespace {

TEST(NumberList, SplitsAtEverySeparator) {
    EXPECT_EQ(split("a,b", ','), (std::vector<std::string_view>{"a", "b"}));
    EXPECT_EQ(split("", ','), (std::vector<std::string_view>{""}));
    EXPECT_EQ(split(",a,,", ','), (std::vector<std::string_view>{"", "a", "", ""}));
}

TEST(NumberList, HasNumbersAndNothingElse) {
    EXPECT_EQ(numbers_of<double>("0.5,-1e3", ','), (std::vector<double>{0.5, -1000.0}));
    EXPECT_EQ(numbers_of<int>("640x480", 'x'), (std::vector<int>{640, 480}));
    for (const char* text : {"", "1,", ",1", "1, 2", "1;2", "0x1", "one"}) {
        EXPECT_EQ(numbers_of<double>(text, ','), std::nullopt) << text;
    }
    EXPECT_EQ(number_of<int>("1.5"), std::nullopt);
    EXPECT_EQ(number_of<int>("99999999999"), std::nullopt);
}

}  // namespace
}  // namespace emulsion::cli
