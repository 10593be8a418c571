#include "develop/pipeline.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"

namespace emulsion {
namespace {

using testing::HasSubstr;

/// A value in the range of a parameter, drawn by rejection from all bit patterns.
void draw(const ParameterRange& range, Pcg32& random, float& value) {
    do value = std::bit_cast<float>(random.next());
    while (!range.contains(value));
}
void draw(const ParameterRange& range, Pcg32& random, double& value) {
    do value = std::bit_cast<double>(std::uint64_t{random.next()} << 32u | random.next());
    while (!range.contains(value));
}
void draw(const ParameterRange& range, Pcg32& random, int& value) {
    do value = std::bit_cast<int>(random.next());
    while (!range.contains(value));
}

/// Gives every parameter a random value in its range.
template <NamedVariant Variant>
void randomise(Variant& variant, Pcg32& random) {
    std::visit(
        [&]<class T>(T& value) {
            for (const Parameter<T>& parameter : parameters_of<T>()) {
                std::visit([&](auto member) { draw(parameter.range, random, value.*member); }, parameter.member);
            }
        },
        variant);
}

/// Calls visitor(pipeline) for every combination of alternatives.
template <class Visitor>
void for_each_pipeline(const Visitor& visitor) {
    Pipeline pipeline;
    for_each_alternative<ToneMapper>([&](const auto& tone_mapper) {
        pipeline.tone_mapper = tone_mapper;
        for_each_alternative<Display>([&](const auto& display) {
            pipeline.display = display;
            for_each_alternative<GamutMapper>([&](const auto& gamut) {
                pipeline.gamut = gamut;
                for_each_alternative<TransferFunction>([&](const auto& transfer) {
                    pipeline.transfer = transfer;
                    for_each_alternative<Dither>([&](const auto& dither) {
                        pipeline.dither = dither;
                        visitor(pipeline);
                    });
                });
            });
        });
    });
}

std::string message_of(std::string_view text) {
    try {
        return "no error: " + to_text(parse_pipeline(text));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(Pipeline, TextOfTheDefault) {
    EXPECT_EQ(
        to_text(Pipeline{}),
        "bloom=none vision=none tonemap=reinhard-global:key=0.18,white=inf adaptation=own display=srgb gamut=clip "
        "transfer=srgb bits=8 range=full dither=floyd-steinberg");
}

TEST(Pipeline, EveryCombinationReadsBackAsTheSameValue) {
    int combinations = 0;
    for_each_pipeline([&](const Pipeline& pipeline) {
        EXPECT_EQ(parse_pipeline(to_text(pipeline)), pipeline) << to_text(pipeline);
        ++combinations;
    });
    EXPECT_GE(combinations, 4);
}

TEST(Pipeline, RandomParametersReadBackAsTheSameValue) {
    Pcg32 random(70);
    std::vector<Adaptation> adaptations;
    for_each_alternative<Adaptation>([&](const auto& adaptation) { adaptations.emplace_back(adaptation); });
    for (int round = 0; round < 300; ++round) {
        for_each_pipeline([&](Pipeline pipeline) {
            pipeline.bloom = QuarticBloom{};
            pipeline.vision = HumanVision{};
            randomise(pipeline.bloom, random);
            randomise(pipeline.vision, random);
            pipeline.adaptation = adaptations[random.next() % adaptations.size()];
            randomise(pipeline.tone_mapper, random);
            randomise(*pipeline.adaptation, random);
            randomise(pipeline.display, random);
            randomise(pipeline.gamut, random);
            randomise(pipeline.transfer, random);
            randomise(pipeline.dither, random);
            EXPECT_NO_THROW(validate(pipeline));
            ASSERT_EQ(parse_pipeline(to_text(pipeline)), pipeline) << to_text(pipeline);
        });
    }
}

/// One alternative, each as likely, with its parameters at random.
template <NamedVariant Variant>
Variant drawn(Pcg32& random) {
    std::vector<Variant> all;
    for_each_alternative<Variant>([&](const auto& value) { all.emplace_back(value); });
    Variant variant = all[random.next() % all.size()];
    randomise(variant, random);
    return variant;
}

// Every stage at random: no test needs to know of a new alternative.
TEST(Pipeline, AThousandRandomPipelinesReadBackAsTheSameValue) {
    Pcg32 random(71);
    for (int round = 0; round < 1000; ++round) {
        Pipeline pipeline{.bloom = drawn<Bloom>(random),
                          .vision = drawn<Vision>(random),
                          .tone_mapper = drawn<ToneMapper>(random),
                          .display = drawn<Display>(random),
                          .gamut = drawn<GamutMapper>(random),
                          .transfer = drawn<TransferFunction>(random),
                          .bits = 1 + static_cast<int>(random.next() % 16),
                          .range = drawn<CodeRange>(random),
                          .dither = drawn<Dither>(random)};
        if (random.next() % 2 == 0) pipeline.adaptation = drawn<Adaptation>(random);
        const std::string text = to_text(pipeline);
        ASSERT_EQ(parse_pipeline(text), pipeline) << text;
        ASSERT_EQ(to_text(parse_pipeline(text)), text);
    }
}

TEST(Pipeline, EveryAdaptationReadsBackAsTheSameValue) {
    for_each_alternative<Adaptation>([](const auto& adaptation) {
        Pipeline pipeline;
        pipeline.adaptation = adaptation;
        EXPECT_EQ(parse_pipeline(to_text(pipeline)), pipeline) << to_text(pipeline);
    });
    EXPECT_EQ(parse_pipeline("adaptation=own"), Pipeline{});
    EXPECT_EQ(parse_pipeline("adaptation=spot:x=0.25").adaptation, Adaptation(SpotAdaptation{0.25f}));
    EXPECT_THAT(message_of("adaptation=spto"), HasSubstr("adaptation \"spto\": unknown; expected spot"));
    EXPECT_EQ(message_of("adaptation=spot:y=2"), "adaptation spot: y = 2: must be in [0, 1]");
}

TEST(Pipeline, LeftOutStagesHaveTheirDefault) {
    EXPECT_EQ(parse_pipeline(""), Pipeline{});
    EXPECT_EQ(parse_pipeline("  \n"), Pipeline{});
    Pipeline expected;
    expected.dither = NoDither{};
    expected.tone_mapper = ReinhardGlobal{0.5f};
    EXPECT_EQ(parse_pipeline(" dither=none\ttonemap=reinhard-global:key=0.5 \n"), expected);
}

TEST(Pipeline, StagesBeforeToneMappingReadBackAsTheSameValue) {
    Pipeline expected;
    expected.bloom = QuarticBloom{0.25f, 0.5f};
    expected.vision = HumanVision{.fov = 30.0f, .rods = 0.5f};
    EXPECT_EQ(parse_pipeline("vision=human:fov=30,rods=0.5 bloom=quartic:radius=0.25,weight=0.5"), expected);
    EXPECT_EQ(parse_pipeline(to_text(expected)), expected);
    EXPECT_EQ(message_of("bloom=quartic:weight=2"), "bloom quartic: weight = 2: must be in [0, 1]");
    EXPECT_EQ(message_of("vision=human:fov=180"), "vision human: fov = 180: must be in [1, 170]");
}

TEST(Pipeline, WrongTextsNameWhatIsRight) {
    EXPECT_EQ(message_of("tonemapper=max-to-white"),
              "pipeline stage \"tonemapper\": unknown; expected tonemap, transfer, range, dither, bloom, adaptation, "
              "display, "
              "gamut, vision or bits");
    EXPECT_THAT(message_of("tonemap=max-to-whit"),
                HasSubstr("tonemap \"max-to-whit\": unknown; expected max-to-white, "));
    EXPECT_EQ(message_of("tonemap=reinhard-global:key=-1"), "tonemap reinhard-global: key = -1: must be in [0, inf)");
    EXPECT_EQ(message_of("bits=17"), "bits = 17: must be in [1, 16]");
    EXPECT_EQ(message_of("bits=x"), "bits = \"x\": not a whole number");
    EXPECT_EQ(message_of("dither"), "pipeline: found \"dither\", expected stage=value");
    EXPECT_EQ(message_of("bits=8 bits=8"), "pipeline: bits given twice");
    EXPECT_THAT(message_of("dither="), HasSubstr("expected none or floyd-steinberg"));
    EXPECT_THAT(message_of("=8"), HasSubstr("pipeline stage \"\": unknown"));
}

TEST(Pipeline, ValidateNamesTheStage) {
    Pipeline pipeline;
    pipeline.adaptation = CentreWeightedAdaptation{0.0f};
    EXPECT_THAT([&] { validate(pipeline); }, testing::ThrowsMessage<std::invalid_argument>(
                                                 "adaptation centre-weighted: sigma = 0: must be in (0, inf)"));
    pipeline = {};
    pipeline.bits = 17;
    EXPECT_THAT([&] { validate(pipeline); },
                testing::ThrowsMessage<std::invalid_argument>("bits = 17: must be in [1, 16]"));
    pipeline = {};
    pipeline.tone_mapper = ReinhardGlobal{-1.0f};
    EXPECT_THAT([&] { validate(pipeline); }, testing::ThrowsMessage<std::invalid_argument>(
                                                 "tonemap reinhard-global: key = -1: must be in [0, inf)"));
}

}  // namespace
}  // namespace emulsion
