// Parameters that may be words, and those that are one of a few.

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "named_value_fixture.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::StrEq;
using testing::ThrowsMessage;

struct Automatic {
    static constexpr std::string_view kName = "automatic";
    static constexpr std::string_view kHelp = "parameters that may be words";
    float width = 0.0f;
    int count = 4;
    bool operator==(const Automatic&) const = default;

    static constexpr std::array kCounts = {ParameterWord{"none", 0}, ParameterWord{"every", -1}};
    static constexpr std::array kParameters = {
        Parameter<Automatic>{"width", &Automatic::width, kPositiveFinite, "px", "how wide", kAutomatic},
        Parameter<Automatic>{"count", &Automatic::count, {1.0, 9.0}, "", "how many", kCounts}};
};
using AutomaticAlone = std::variant<Automatic>;

TEST(NamedValueWords, SpecialValuesAreWrittenAsTheirWords) {
    EXPECT_EQ(to_text(Automatic{}), "automatic:width=auto,count=4");
    EXPECT_EQ(to_text(Automatic{2.5f, 0}), "automatic:width=2.5,count=none");
    EXPECT_EQ(to_text(Automatic{-0.0f, -1}), "automatic:width=auto,count=every");
}

TEST(NamedValueWords, SpecialValuesAreReadFromTheirWords) {
    const auto read = [](std::string_view text) { return parse_named<AutomaticAlone>(text, "thing"); };
    EXPECT_EQ(read("automatic:width=auto,count=none"), AutomaticAlone(Automatic{0.0f, 0}));
    EXPECT_EQ(read("automatic:width=AUTO"), AutomaticAlone(Automatic{0.0f, 4}));
    EXPECT_EQ(read("automatic:width=3,count=Every"), AutomaticAlone(Automatic{3.0f, -1}));
    EXPECT_NO_THROW(validate_named(Automatic{0.0f, -1}, "thing"));
}

/// What reading or validating says when it fails.
template <class Call>
std::string refusal(Call&& call) {
    try {
        call();
        return "";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

// 0 is how a value keeps "auto", and no number that one may write.
TEST(NamedValueWords, NumbersOfSpecialValuesAreRefused) {
    const auto read = [](const char* text) {
        return refusal([&] { (void)parse_named<AutomaticAlone>(text, "thing"); });
    };
    EXPECT_EQ(read("automatic:width=0"), "thing automatic: width = 0: must be auto or in (0, inf)");
    EXPECT_EQ(read("automatic:width=-0"), "thing automatic: width = -0: must be auto or in (0, inf)");
    EXPECT_EQ(read("automatic:width=-1"), "thing automatic: width = -1: must be auto or in (0, inf)");
    EXPECT_EQ(read("automatic:count=0"), "thing automatic: count = 0: must be none, every or in [1, 9]");
    EXPECT_EQ(read("automatic:count=-1"), "thing automatic: count = -1: must be none, every or in [1, 9]");
    EXPECT_EQ(refusal([] {
                  validate_named(Automatic{-1.0f, 4}, "thing");
              }),
              "thing automatic: width = -1: must be auto or in (0, inf)");
}

TEST(NamedValueWords, WhatIsNeitherWordNorNumberIsRefusedWithTheWords) {
    const auto read = [](const char* text) {
        return refusal([&] { (void)parse_named<AutomaticAlone>(text, "thing"); });
    };
    EXPECT_EQ(read("automatic:width=abc"), "thing automatic: width = \"abc\": neither auto nor a number");
    EXPECT_EQ(read("automatic:count=2.5"),
              "thing automatic: count = \"2.5\": neither none nor every nor a whole number");
    EXPECT_EQ(read("automatic:width=1e39"), "thing automatic: width = \"1e39\": too large or too small to be held");
}

TEST(NamedValueWords, WordOfAnotherParameterIsNoNumber) {
    EXPECT_THAT(
        [] { (void)parse_named<AutomaticAlone>("automatic:width=none", "thing"); },
        ThrowsMessage<std::invalid_argument>(StrEq("thing automatic: width = \"none\": neither auto nor a number")));
    EXPECT_EQ(message_of("blur:radius=auto"), "effect blur: radius = \"auto\": not a number");
}

TEST(NamedValueWords, DescribesSpecialWords) {
    const auto all = describe_named<AutomaticAlone>();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_THAT(all[0].parameters,
                ElementsAre(ParameterDescription{"width", "auto", "auto or (0, inf)", "px", "how wide"},
                            ParameterDescription{"count", "4", "none, every or [1, 9]", "", "how many"}));
    EXPECT_EQ(range_text({0.0, 1.0}, {}), "[0, 1]");
}

constexpr std::array kSizes = {ParameterWord{"2", 2}, ParameterWord{"8", 8}, ParameterWord{"every", 0}};

struct Chosen {
    static constexpr std::string_view kName = "chosen";
    static constexpr std::string_view kHelp = "of a few";
    int size = 8;
    bool operator==(const Chosen&) const = default;

    static constexpr std::array kParameters = {
        Parameter<Chosen>{"size", &Chosen::size, {0.0, 8.0}, "px", "how large", {}, kSizes}};
};
using ChosenAlone = std::variant<Chosen>;

TEST(NamedValueWords, ChoicesAreWrittenAndReadAsWords) {
    EXPECT_EQ(to_text(Chosen{}), "chosen:size=8");
    EXPECT_EQ(to_text(Chosen{0}), "chosen:size=every");
    EXPECT_EQ(parse_named<ChosenAlone>("chosen:size=2", "thing"), ChosenAlone(Chosen{2}));
    EXPECT_EQ(parse_named<ChosenAlone>("chosen:size=Every", "thing"), ChosenAlone(Chosen{0}));
    EXPECT_EQ(describe_named<ChosenAlone>()[0].parameters[0].range_text, "{2, 8, every}");
}

TEST(NamedValueWords, OtherThanTheChoicesAreRefused) {
    for (const std::string_view wrong : {"0", "4", "16", "", "ever"}) {
        EXPECT_THAT([&] { (void)parse_named<ChosenAlone>("chosen:size=" + std::string(wrong), "thing"); },
                    ThrowsMessage<std::invalid_argument>(
                        StrEq("thing chosen: size = \"" + std::string(wrong) + "\": must be in {2, 8, every}")));
    }
    EXPECT_THAT([] { validate_named(Chosen{4}, "thing"); },
                ThrowsMessage<std::invalid_argument>(StrEq("thing chosen: size = 4: must be in {2, 8, every}")));
}

}  // namespace
}  // namespace emulsion
