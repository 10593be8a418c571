#include "cli/json_text.h"

#include <limits>

#include <gtest/gtest.h>

namespace emulsion::cli {
namespace {

TEST(JsonText, EscapesWhatHasToBe) {
    EXPECT_EQ(json_text(""), R"("")");
    EXPECT_EQ(json_text("a \"b\" \\ \n"), R"("a \"b\" \\ \u000a")");
    EXPECT_EQ(json_text("\xc3\xa9\xe2\x82\xac\xf0\x9f\x8e\xa8"), "\"\xc3\xa9\xe2\x82\xac\xf0\x9f\x8e\xa8\"");
}

/// The borders of Unicode's table 3-7 of well-formed sequences: each of these has one byte wrong.
TEST(JsonText, ReplacesWhatIsNoUtf8) {
    EXPECT_EQ(json_text("a\xff"), R"("a\ufffd")");
    EXPECT_EQ(json_text("\xc3"), R"("\ufffd")");                          // cut off
    EXPECT_EQ(json_text("\xc3z"), R"("\ufffdz")");                        // no continuation
    EXPECT_EQ(json_text("\xc1\xbf"), R"("\ufffd\ufffd")");                // overlong
    EXPECT_EQ(json_text("\xed\xa0\x80").substr(0, 7), R"("\ufffd)");      // a surrogate
    EXPECT_EQ(json_text("\xf4\x90\x80\x80").substr(0, 7), R"("\ufffd)");  // above U+10FFFF
    EXPECT_EQ(json_text("\xed\x9f\xbf\xf4\x8f\xbf\xbf"), "\"\xed\x9f\xbf\xf4\x8f\xbf\xbf\"");
}

TEST(JsonNumber, HasSeventeenDigitsOrIsNull) {
    EXPECT_EQ(json_number(0.1), "0.10000000000000001");
    EXPECT_EQ(json_number(std::numeric_limits<double>::infinity()), "null");
    EXPECT_EQ(json_number(std::numeric_limits<double>::quiet_NaN()), "null");
}

}  // namespace
}  // namespace emulsion::cli
