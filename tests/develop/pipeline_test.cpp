#include "develop/pipeline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"
#include "spectrum/chromaticity_polygon.h"

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
    const double past = std::floor(std::min(range.max, 1e9)) + 1.0;
    const double first = std::max(range.min, -1e9);
    do value = static_cast<int>(std::floor(first + (past - first) * random.next_float()));
    while (!range.contains(value));
}
/// One of the choices, as far as there are any.
template <class T>
void draw(const Parameter<T>& parameter, Pcg32& random, T& value) {
    std::visit(
        [&]<class M>(M T::*member) {
            const bool is_special = !parameter.special.empty() && random.next() % 4 == 0;
            const auto words = is_special ? parameter.special : parameter.words;
            if (words.empty()) return draw(parameter.range, random, value.*member);
            value.*member = static_cast<M>(words[random.next() % words.size()].value);
        },
        parameter.member);
}

/// Gives every parameter a random value in its range.
template <NamedVariant Variant>
void randomise(Variant& variant, Pcg32& random) {
    std::visit(
        [&]<class T>(T& value) {
            for (const Parameter<T>& parameter : parameters_of<T>()) draw(parameter, random, value);
        },
        variant);
}

/// One of the alternatives, with random parameters.
template <NamedVariant Variant>
Variant random_value(Pcg32& random) {
    std::vector<Variant> alternatives;
    for_each_alternative<Variant>([&](const auto& chosen) { alternatives.emplace_back(chosen); });
    Variant value = alternatives[random.next() % alternatives.size()];
    randomise(value, random);
    return value;
}

/// Any triangle with the white of D65 in it, to all digits.
void draw_triangle(CustomDisplay& display, Pcg32& random) {
    do {
        for (double CustomDisplay::*member : {&CustomDisplay::rx, &CustomDisplay::ry, &CustomDisplay::gx,
                                              &CustomDisplay::gy, &CustomDisplay::bx, &CustomDisplay::by}) {
            display.*member = random.next() * 0x1p-32;
        }
        display.wx = 0.3127;
        display.wy = 0.329;
    } while (signed_distance(convex_hull(std::vector<Chromaticity>{
                                 {display.rx, display.ry}, {display.gx, display.gy}, {display.bx, display.by}}),
                             {display.wx, display.wy}) < 0.01);
}

Display random_display(Pcg32& random) {
    auto display = random_value<Display>(random);
    if (auto* custom = std::get_if<CustomDisplay>(&display)) draw_triangle(*custom, random);
    return display;
}

SceneWhite random_white(Pcg32& random) {
    auto white = random_value<SceneWhite>(random);
    const double x = 0.25 + 0.2 * 0x1p-32 * random.next(), y = 0.25 + 0.2 * 0x1p-32 * random.next();
    std::visit(
        [&]<class T>(T& chosen) {
            if constexpr (!std::is_empty_v<T>) chosen.x = x, chosen.y = y;
        },
        white);
    return white;
}

/// Every stage with its parameters at random, in their ranges and so that they go together.
Pipeline random_pipeline(Pcg32& random) {
    Pipeline pipeline;
    pipeline.bloom = random_value<Bloom>(random);
    pipeline.vision = random_value<Vision>(random);
    pipeline.tone_mapper = random_value<ToneMapper>(random);
    if (random.next() % 2 == 0) pipeline.adaptation = random_value<Adaptation>(random);
    pipeline.precision = random_value<Precision>(random);
    pipeline.scene_white = random_white(random);
    pipeline.display = random_display(random);
    pipeline.gamut = random_value<GamutMapper>(random);
    if (random.next() % 4 != 0) pipeline.transfer = random_value<TransferFunction>(random);
    pipeline.range = random_value<CodeRange>(random);
    const int least_bits = std::holds_alternative<FullRange>(pipeline.range) ? 1 : 8;
    pipeline.bits = least_bits + static_cast<int>(random.next() % static_cast<unsigned>(17 - least_bits));
    pipeline.dither = random_value<Dither>(random);
    return pipeline;
}

std::string message_of(std::string_view text) {
    try {
        return "no error: " + to_text(parse_pipeline(text));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(Pipeline, TextOfTheDefault) {
    EXPECT_EQ(to_text(Pipeline{}),
              "bloom=none vision=none tonemap=reinhard-global:key=0.18,white=inf adaptation=own precision=fast "
              "scene-white=none "
              "display=srgb:peak=80,black=0,flare=0 gamut=clip transfer=own bits=8 range=full "
              "dither=blue-noise:size=128");
}

// Every alternative of every stage, many times over and in the most various company.
TEST(Pipeline, ThousandsOfRandomOnesReadBackAsTheSameValue) {
    Pcg32 random(70);
    for (int round = 0; round < 10000; ++round) {
        const Pipeline pipeline = random_pipeline(random);
        ASSERT_NO_THROW(validate(pipeline)) << to_text(pipeline);
        ASSERT_EQ(parse_pipeline(to_text(pipeline)), pipeline) << to_text(pipeline);
    }
}

TEST(Pipeline, OwnTransferIsThatOfTheDisplay) {
    EXPECT_EQ(transfer_of({}), TransferFunction(SrgbTransfer{}));
    EXPECT_EQ(transfer_of({.display = Hdr10Display{}}), TransferFunction(PqTransfer{}));
    EXPECT_EQ(transfer_of({.display = CrtDisplay{}}), TransferFunction(GammaTransfer{2.5}));
    EXPECT_EQ(transfer_of({.display = CrtDisplay{}, .transfer = LinearTransfer{}}), TransferFunction(LinearTransfer{}));
    EXPECT_EQ(parse_pipeline("transfer=own"), Pipeline{});
    EXPECT_EQ(parse_pipeline("transfer=srgb").transfer, TransferFunction(SrgbTransfer{}));
    EXPECT_EQ(message_of("transfer=gamma:exponent=9"), "transfer gamma: exponent = 9: must be in [0.1, 5]");
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
              "precision, scene-white, display, gamut, vision or bits");
    EXPECT_THAT(message_of("tonemap=max-to-whit"),
                HasSubstr("tonemap \"max-to-whit\": unknown; expected max-to-white, "));
    EXPECT_EQ(message_of("tonemap=reinhard-global:key=-1"),
              "tonemap reinhard-global: key = -1: must be auto or in (0, inf)");
    EXPECT_EQ(message_of("bits=17"), "bits = 17: must be in [1, 16]");
    EXPECT_EQ(message_of("bits=x"), "bits = \"x\": not a whole number");
    EXPECT_EQ(message_of("dither"), "pipeline: found \"dither\", expected stage=value");
    EXPECT_THAT(message_of("display=rec709"), HasSubstr("display \"rec709\": unknown; expected rec2020, "));
    EXPECT_EQ(message_of("display=hlg:peak=100"), "display hlg: peak = 100: must be in [400, 2000]");
    EXPECT_THAT(message_of("display=custom:wx=0.7"), HasSubstr("white (0.7, 0.329): must lie inside the triangle"));
    EXPECT_THAT(message_of("scene-white=bradford:x=0.9,y=0.9"), HasSubstr("scene-white bradford:x=0.9,y=0.9: "));
    EXPECT_EQ(message_of("bits=7 range=narrow"), "bits of the narrow range = 7: must be in [8, 16]");
    EXPECT_EQ(message_of("scene-white=bradford:y=0"), "scene-white bradford: y = 0: must be in (0, 1]");
    EXPECT_EQ(message_of("bits=8 bits=8"), "pipeline: bits given twice");
    EXPECT_THAT(message_of("dither="), HasSubstr("expected none, "));
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
                                                 "tonemap reinhard-global: key = -1: must be auto or in (0, inf)"));
}

}  // namespace
}  // namespace emulsion
