#include "compare/precision_choice.h"

#include <limits>
#include <stdexcept>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "develop/develop.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A bright window in a dark wall with some texture: edges, at which local adaptations work.
Image<XYZ> window_picture(int width, int height) {
    Image<XYZ> scene(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool is_window = 3 * x > width && 2 * x < width && 3 * y > height && 3 * y < 2 * height;
            const float texture = 1.0f + 0.2f * static_cast<float>((x * 7919 + y * 104729) % 11) / 10.0f;
            const float luminance = (is_window ? 500.0f : 3.0f) * texture;
            scene(x, y) = {luminance, luminance, 1.1f * luminance};
        }
    }
    return scene;
}

Pipeline pipeline_of(const ToneMapper& mapper) {
    Pipeline pipeline;
    pipeline.tone_mapper = mapper;
    return pipeline;
}

TEST(PrecisionChoice, IsReadFromItsText) {
    EXPECT_EQ(parse_precision_choice("fast"), PrecisionChoice(FastPrecision{}));
    EXPECT_EQ(parse_precision_choice("reference"), PrecisionChoice(ReferencePrecision{}));
    EXPECT_EQ(parse_precision_choice("auto:0.5,9"), PrecisionChoice(AutoPrecision{{0.5, 9.0}}));
    EXPECT_THROW((void)parse_precision_choice("exact"), std::invalid_argument);
    EXPECT_THROW((void)parse_precision_choice("auto:x"), std::invalid_argument);
}

// A curve for the whole picture is a table within 2e-4, which is 0.008 in L*.
TEST(PrecisionChoice, OfOneCurveForThePictureFastWillDo) {
    const PrecisionLoss loss = precision_loss(window_picture(96, 64), pipeline_of(ReinhardGlobal{}));
    EXPECT_LT(loss.ciede2000.max, 0.01);
    EXPECT_GT(loss.ciede2000.max, 0.0);
    const PrecisionDecision decision = decide_precision(loss, {0.01, 0.03});
    EXPECT_EQ(decision.precision, Precision(FastPrecision{}));
    EXPECT_THAT(decision.reason, AllOf(StartsWith("fast: dE00 "), HasSubstr("on 96x64 pixels, within 0.01 and 0.03")));
}

// A local adaptation is off at edges: too much for a tight budget, and not for the usual one.
TEST(PrecisionChoice, OfALocalOperatorATightBudgetWantsTheReference) {
    const PrecisionLoss loss = precision_loss(window_picture(96, 64), pipeline_of(HighContrast{}));
    EXPECT_GT(loss.ciede2000.mean, 1e-3);
    const PrecisionDecision tight = decide_precision(loss, {1e-3, 3e-3});
    EXPECT_EQ(tight.precision, Precision(ReferencePrecision{}));
    EXPECT_THAT(tight.reason, AllOf(StartsWith("reference: fast has dE00 "), HasSubstr("asked for 0.001 and 0.003")));
    EXPECT_EQ(decide_precision(loss, {}).precision, Precision(FastPrecision{}));
}

TEST(PrecisionChoice, ABudgetOfNothingIsTheReference) {
    const PrecisionLoss loss = precision_loss(window_picture(96, 64), pipeline_of(ReinhardGlobal{}));
    EXPECT_EQ(decide_precision(loss, {0.0, 0.0}).precision, Precision(ReferencePrecision{}));
    EXPECT_THROW((void)decide_precision(loss, {-1.0, 0.0}), std::invalid_argument);
}

// Bloom's fast kernel is 5 % of its peak off: without it, maximum-to-white has nothing to lose.
TEST(PrecisionChoice, BloomAndVisionCount) {
    Pipeline pipeline = pipeline_of(MaxToWhite{});
    const Image<XYZ> scene = window_picture(48, 32);
    const double plain = precision_loss(scene, pipeline).ciede2000.mean;
    pipeline.bloom = QuarticBloom{.radius = 0.2f, .weight = 0.5f};
    const double bloomed = precision_loss(scene, pipeline).ciede2000.mean;
    pipeline.vision = HumanVision{};
    const double seen = precision_loss(scene, pipeline).ciede2000.mean;
    EXPECT_LT(plain, 1e-4);
    EXPECT_GT(bloomed, 10.0 * plain);
    EXPECT_NE(seen, bloomed);
}

TEST(PrecisionChoice, LooksAtAPictureMadeSmaller) {
    const PrecisionLoss loss = precision_loss(window_picture(512, 128), pipeline_of(Drago{}));
    EXPECT_EQ(loss.width_px, 256);
    EXPECT_EQ(loss.height_px, 64);
    const PrecisionLoss smaller = precision_loss(window_picture(512, 128), pipeline_of(Drago{}), {.most_px = 64});
    EXPECT_EQ(smaller.width_px, 64);
    EXPECT_EQ(smaller.ciede2000.pixels, 64 * 16);
}

TEST(PrecisionChoice, DoesNotDependOnThreadsNorOnThePipelinesOwnPrecision) {
    const Image<XYZ> scene = window_picture(96, 64);
    Pipeline pipeline = pipeline_of(Durand{});
    const PrecisionLoss one = precision_loss(scene, pipeline, {.threads = 1});
    pipeline.precision = ReferencePrecision{};
    const PrecisionLoss four = precision_loss(scene, pipeline, {.threads = 4});
    EXPECT_EQ(one.ciede2000, four.ciede2000);
    EXPECT_GT(one.ciede2000.mean, 0.0);
}

// Bad pixels are no part of the mean of their block.
TEST(PrecisionChoice, BadPixelsAreLeftOut) {
    Image<XYZ> scene = window_picture(512, 128);
    const PrecisionLoss clean = precision_loss(scene, pipeline_of(ReinhardGlobal{}));
    scene(7, 7).y = std::numeric_limits<float>::quiet_NaN();
    scene(9, 7).x = std::numeric_limits<float>::infinity();
    scene(11, 7).y = -1e6f;
    const PrecisionLoss spoilt = precision_loss(scene, pipeline_of(ReinhardGlobal{}));
    EXPECT_EQ(spoilt.ciede2000.pixels, clean.ciede2000.pixels);
    EXPECT_LT(spoilt.ciede2000.max, 0.01);
}

TEST(PrecisionChoice, RefusesWhatDevelopWould) {
    EXPECT_THROW((void)precision_loss(window_picture(8, 8), pipeline_of(ReinhardGlobal{-1.0f})), std::invalid_argument);
    EXPECT_THROW((void)precision_loss(Image<XYZ>(), {}), std::invalid_argument);
    EXPECT_THROW((void)precision_loss(window_picture(8, 8), {}, {.most_px = 0}), std::invalid_argument);
    EXPECT_THROW((void)precision_loss(window_picture(8, 8), {}, {.threads = -1}), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion::testing
