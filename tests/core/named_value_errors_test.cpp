// What is said of text that is no named value.

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "named_value_fixture.h"

namespace emulsion {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

TEST(NamedValueErrors, UnknownNameListsTheNearestFirst) {
    EXPECT_EQ(message_of("blurr"), "effect \"blurr\": unknown; expected blur or plain");
    EXPECT_EQ(message_of("plane"), "effect \"plane\": unknown; expected plain or blur");
    EXPECT_EQ(message_of(""), "effect \"\": unknown; expected blur or plain");
}

TEST(NamedValueErrors, UnknownParameterListsTheNearestFirst) {
    EXPECT_EQ(message_of("blur:pass=1"),
              "effect blur: parameter \"pass\": unknown; expected passes, radius or strength");
    EXPECT_EQ(message_of("plain:radius=1"), "effect plain: parameter \"radius\": unknown; there are none");
}

TEST(NamedValueErrors, OutOfRangeNamesTheRange) {
    EXPECT_EQ(message_of("blur:radius=0"), "effect blur: radius = 0: must be in (0, inf)");
    EXPECT_EQ(message_of("blur:radius=inf"), "effect blur: radius = inf: must be in (0, inf)");
    EXPECT_EQ(message_of("blur:strength=-0.1"), "effect blur: strength = -0.1: must be in (0, inf]");
    EXPECT_EQ(message_of("blur:passes=17"), "effect blur: passes = 17: must be in [1, 16]");
    EXPECT_EQ(message_of("blur:strength=nan"), "effect blur: strength = nan: must be in (0, inf]");
}

TEST(NamedValueErrors, MalformedNumberSaysSo) {
    for (const char* text : {"", "x", "1x", " 1", "1 ", "+1", "1,5", "0x10", "--1", "1e", "."}) {
        const std::string assignment = std::string("blur:radius=") + text;
        EXPECT_NE(message_of(assignment).find("effect blur"), std::string::npos) << assignment;
        EXPECT_EQ(message_of(assignment).find("no error"), std::string::npos) << assignment;
    }
    EXPECT_EQ(message_of("blur:radius=1x"), "effect blur: radius = \"1x\": not a number");
    EXPECT_EQ(message_of("blur:passes=2.5"), "effect blur: passes = \"2.5\": not a whole number");
    EXPECT_EQ(message_of("blur:passes=1e1"), "effect blur: passes = \"1e1\": not a whole number");
    EXPECT_EQ(message_of("blur:radius=1e39"), "effect blur: radius = \"1e39\": too large or too small to be held");
    EXPECT_EQ(message_of("blur:radius=1e-60"), "effect blur: radius = \"1e-60\": too large or too small to be held");
    EXPECT_EQ(message_of("blur:passes=3000000000"),
              "effect blur: passes = \"3000000000\": too large or too small to be held");
}

TEST(NamedValueErrors, MalformedListSaysSo) {
    EXPECT_EQ(message_of("blur:"), "effect blur: found \"\", expected parameter=value");
    EXPECT_EQ(message_of("blur:radius"), "effect blur: found \"radius\", expected parameter=value");
    EXPECT_EQ(message_of("blur:radius=1,"), "effect blur: found \"\", expected parameter=value");
    EXPECT_EQ(message_of("blur:=1"), "effect blur: found \"=1\", expected parameter=value");
    EXPECT_EQ(message_of("blur:radius=1,radius=1"), "effect blur: radius: given twice");
}

TEST(NamedValueErrors, ValidateNamesTheParameter) {
    EXPECT_NO_THROW(validate_named(Effect{Blur{}}, "effect"));
    EXPECT_THAT(
        [] {
            validate_named(Effect{Blur{1.0f, 1.0f, 0}}, "effect");
        },
        ThrowsMessage<std::invalid_argument>(StrEq("effect blur: passes = 0: must be in [1, 16]")));
    EXPECT_THAT(
        [] {
            validate_named(Blur{0.0f, 1.0f, 1});
        },
        ThrowsMessage<std::invalid_argument>(StrEq("blur: radius = 0: must be in (0, inf)")));
}

}  // namespace
}  // namespace emulsion
