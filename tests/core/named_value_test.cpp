#include "core/named_value.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "named_value_fixture.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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

TEST(NamedValue, CaseMakesNoDifference) {
    EXPECT_EQ(message_of("Blur:RADIUS=2,Passes=3"), message_of("blur:radius=2,passes=3"));
    EXPECT_EQ(message_of("BLUR").substr(0, 14), "no error: blur");
    EXPECT_EQ(message_of("blur:radius=1,Radius=2"), "effect blur: Radius: given twice");
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
