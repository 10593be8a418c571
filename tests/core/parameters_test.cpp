#include "core/parameters.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::StrEq;
using testing::ThrowsMessage;

struct Plain {
    static constexpr std::string_view kName = "plain";
    static constexpr std::string_view kHelp = "nothing to set";
    bool operator==(const Plain&) const = default;
};

struct Blur {
    static constexpr std::string_view kName = "blur";
    static constexpr std::string_view kHelp = "a picture out of focus";
    float radius_px = 1.5f;
    float strength = std::numeric_limits<float>::infinity();
    int passes = 3;
    bool operator==(const Blur&) const = default;

    static constexpr std::array kParameters = {
        Parameter<Blur>{"radius", &Blur::radius_px, kPositiveFinite, "px", "how far"},
        Parameter<Blur>{"strength", &Blur::strength, kPositive, "", "how much"},
        Parameter<Blur>{"passes", &Blur::passes, {1.0, 16.0}, "", "how often"}};
};

using Effect = std::variant<Plain, Blur>;

/// What parsing a text says when it fails.
std::string message_of(std::string_view text) {
    try {
        return "no error: " + to_text(parse_named<Effect>(text, "effect"));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

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

TEST(NamedValue, TextHoldsEveryParameter) {
    EXPECT_EQ(to_text(Effect{Plain{}}), "plain");
    EXPECT_EQ(to_text(Effect{Blur{}}), "blur:radius=1.5,strength=inf,passes=3");
    EXPECT_EQ(to_text(Effect{Blur{0.1f, 1e-30f, 16}}), "blur:radius=0.1,strength=1e-30,passes=16");
}

TEST(NamedValue, LeftOutParametersHaveTheirDefault) {
    EXPECT_EQ(parse_named<Effect>("blur", "effect"), Effect{Blur{}});
    EXPECT_EQ(parse_named<Effect>("plain", "effect"), Effect{Plain{}});
    EXPECT_EQ(parse_named<Effect>("blur:passes=7", "effect"), (Effect{Blur{1.5f, Blur{}.strength, 7}}));
}

TEST(NamedValue, ParametersComeInAnyOrder) {
    EXPECT_EQ(parse_named<Effect>("blur:passes=2,strength=4,radius=3", "effect"), (Effect{Blur{3.0f, 4.0f, 2}}));
}

TEST(NamedValue, EveryFloatSurvivesItsText) {
    Pcg32 random(20);
    int tried = 0;
    while (tried < 20000) {
        const float value = std::abs(std::bit_cast<float>(random.next()));
        if (!kPositiveFinite.contains(value)) continue;
        const Effect effect = Blur{value, value, 1 + static_cast<int>(random.next() % 16)};
        ASSERT_EQ(parse_named<Effect>(to_text(effect), "effect"), effect) << to_text(effect);
        ++tried;
    }
}

struct Precise {
    static constexpr std::string_view kName = "precise";
    static constexpr std::string_view kHelp = "a parameter in double precision";
    double value = 2.2;
    bool operator==(const Precise&) const = default;

    static constexpr std::array kParameters = {Parameter<Precise>{"value", &Precise::value, kFinite, "", "any"}};
};

TEST(NamedValue, EveryDoubleSurvivesItsText) {
    using Alone = std::variant<Precise>;
    EXPECT_EQ(to_text(Precise{}), "precise:value=2.2");
    Pcg32 random(21);
    int tried = 0;
    while (tried < 20000) {
        const Precise value{std::bit_cast<double>(std::uint64_t{random.next()} << 32u | random.next())};
        if (!kFinite.contains(value.value)) continue;
        ASSERT_EQ(parse_named<Alone>(to_text(value), "number"), Alone{value}) << to_text(value);
        ++tried;
    }
    EXPECT_THROW((void)parse_named<Alone>("precise:value=inf", "number"), std::invalid_argument);
}

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

TEST(NamedValue, SpecialValuesAreWrittenAsTheirWords) {
    EXPECT_EQ(to_text(Automatic{}), "automatic:width=auto,count=4");
    EXPECT_EQ(to_text(Automatic{2.5f, 0}), "automatic:width=2.5,count=none");
    EXPECT_EQ(to_text(Automatic{-0.0f, -1}), "automatic:width=auto,count=every");
}

TEST(NamedValue, SpecialValuesAreReadFromTheirWords) {
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
TEST(NamedValue, NumbersOfSpecialValuesAreRefused) {
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

TEST(NamedValue, WordOfAnotherParameterIsNoNumber) {
    EXPECT_THAT([] { (void)parse_named<AutomaticAlone>("automatic:width=none", "thing"); },
                ThrowsMessage<std::invalid_argument>(StrEq("thing automatic: width = \"none\": not a number")));
    EXPECT_EQ(message_of("blur:radius=auto"), "effect blur: radius = \"auto\": not a number");
}

TEST(NamedValue, DescribesSpecialWords) {
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

TEST(NamedValue, ChoicesAreWrittenAndReadAsWords) {
    EXPECT_EQ(to_text(Chosen{}), "chosen:size=8");
    EXPECT_EQ(to_text(Chosen{0}), "chosen:size=every");
    EXPECT_EQ(parse_named<ChosenAlone>("chosen:size=2", "thing"), ChosenAlone(Chosen{2}));
    EXPECT_EQ(parse_named<ChosenAlone>("chosen:size=Every", "thing"), ChosenAlone(Chosen{0}));
    EXPECT_EQ(describe_named<ChosenAlone>()[0].parameters[0].range_text, "{2, 8, every}");
}

TEST(NamedValue, OtherThanTheChoicesAreRefused) {
    for (const std::string_view wrong : {"0", "4", "16", "", "ever"}) {
        EXPECT_THAT([&] { (void)parse_named<ChosenAlone>("chosen:size=" + std::string(wrong), "thing"); },
                    ThrowsMessage<std::invalid_argument>(
                        StrEq("thing chosen: size = \"" + std::string(wrong) + "\": must be in {2, 8, every}")));
    }
    EXPECT_THAT([] { validate_named(Chosen{4}, "thing"); },
                ThrowsMessage<std::invalid_argument>(StrEq("thing chosen: size = 4: must be in {2, 8, every}")));
}

TEST(NamedValue, CaseMakesNoDifference) {
    EXPECT_EQ(message_of("Blur:RADIUS=2,Passes=3"), message_of("blur:radius=2,passes=3"));
    EXPECT_EQ(message_of("BLUR").substr(0, 14), "no error: blur");
    EXPECT_EQ(message_of("blur:radius=1,Radius=2"), "effect blur: Radius: given twice");
}

TEST(NamedValue, UnknownNameListsTheNearestFirst) {
    EXPECT_EQ(message_of("blurr"), "effect \"blurr\": unknown; expected blur or plain");
    EXPECT_EQ(message_of("plane"), "effect \"plane\": unknown; expected plain or blur");
    EXPECT_EQ(message_of(""), "effect \"\": unknown; expected blur or plain");
}

TEST(NamedValue, UnknownParameterListsTheNearestFirst) {
    EXPECT_EQ(message_of("blur:pass=1"),
              "effect blur: parameter \"pass\": unknown; expected passes, radius or strength");
    EXPECT_EQ(message_of("plain:radius=1"), "effect plain: parameter \"radius\": unknown; there are none");
}

TEST(NamedValue, OutOfRangeNamesTheRange) {
    EXPECT_EQ(message_of("blur:radius=0"), "effect blur: radius = 0: must be in (0, inf)");
    EXPECT_EQ(message_of("blur:radius=inf"), "effect blur: radius = inf: must be in (0, inf)");
    EXPECT_EQ(message_of("blur:strength=-0.1"), "effect blur: strength = -0.1: must be in (0, inf]");
    EXPECT_EQ(message_of("blur:passes=17"), "effect blur: passes = 17: must be in [1, 16]");
    EXPECT_EQ(message_of("blur:strength=nan"), "effect blur: strength = nan: must be in (0, inf]");
}

TEST(NamedValue, MalformedNumberSaysSo) {
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

TEST(NamedValue, MalformedListSaysSo) {
    EXPECT_EQ(message_of("blur:"), "effect blur: found \"\", expected parameter=value");
    EXPECT_EQ(message_of("blur:radius"), "effect blur: found \"radius\", expected parameter=value");
    EXPECT_EQ(message_of("blur:radius=1,"), "effect blur: found \"\", expected parameter=value");
    EXPECT_EQ(message_of("blur:=1"), "effect blur: found \"=1\", expected parameter=value");
    EXPECT_EQ(message_of("blur:radius=1,radius=1"), "effect blur: radius: given twice");
}

TEST(NamedValue, ValidateNamesTheParameter) {
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

TEST(NamedValue, DescribesEveryAlternative) {
    const auto all = describe_named<Effect>();
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].name, "plain");
    EXPECT_THAT(all[0].parameters, IsEmpty());
    EXPECT_EQ(all[1].help, "a picture out of focus");
    EXPECT_THAT(all[1].parameters, ElementsAre(ParameterDescription{"radius", "1.5", "(0, inf)", "px", "how far"},
                                               ParameterDescription{"strength", "inf", "(0, inf]", "", "how much"},
                                               ParameterDescription{"passes", "3", "[1, 16]", "", "how often"}));
    EXPECT_THAT(names_of<Effect>(), ElementsAre("plain", "blur"));
}

}  // namespace
}  // namespace emulsion
