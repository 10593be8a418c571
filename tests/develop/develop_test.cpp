#include "develop/develop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"
#include "display/display_encoder.h"
#include "display/display_rgb.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// A colour in scene-referred XYZ from linear sRGB times `scale_cdm2`.
XYZ scene_xyz(const RGB& rgb, double scale_cdm2) {
    const auto xyz = xyz_from_rgb(rgb_space("sRGB")) * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
    return {static_cast<float>(scale_cdm2 * xyz[0]), static_cast<float>(scale_cdm2 * xyz[1]),
            static_cast<float>(scale_cdm2 * xyz[2])};
}

Image<XYZ> random_scene(int width, int height, unsigned seed) {
    Pcg32 random(seed);
    Image<XYZ> scene(width, height);
    for (XYZ& pixel : scene.pixels()) {
        pixel = scene_xyz({random.next_float(), random.next_float(), random.next_float()},
                          std::pow(10.0, 4.0 * random.next_float() - 1.0));
    }
    return scene;
}

// Four decades; no pixel is far from its neighbours, whose part local operators let it play if it is bad.
Image<XYZ> smooth_scene(int width, int height) {
    Image<XYZ> scene(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double wave = std::sin(0.1 * x) + std::cos(0.07 * (x + 2 * y));
            scene(x, y) = scene_xyz({0.8f, 0.5f, 0.4f}, 10.0 * std::pow(10.0, wave));
        }
    }
    return scene;
}

// A ramp of greys, brightest 500 cd/m^2, against the formulas of the chain, all in double precision.
TEST(Develop, GreyRampFollowsTheFormulas) {
    constexpr int kSteps = 4096;
    Image<XYZ> scene(kSteps, 1);
    for (int x = 0; x < kSteps; ++x) {
        const float linear = static_cast<float>(x) / (kSteps - 1);
        scene(x, 0) = scene_xyz({linear, linear, linear}, 500.0);
    }
    const DevelopResult result = develop(scene, {.tone_mapper = MaxToWhite{}, .dither = NoDither{}}, 1);
    int different = 0;
    for (int x = 0; x < kSteps; ++x) {
        const double linear = static_cast<double>(x) / (kSteps - 1);
        const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
        const auto code = static_cast<int>(std::lround(255.0 * encoded));
        const CodeRGB found = result.image(x, 0);
        // Single precision may round the other way within 1e-4 of the edge between two codes.
        const bool on_edge = std::abs(255.0 * encoded - std::floor(255.0 * encoded) - 0.5) < 1e-4;
        for (const int channel : {found.r, found.g, found.b}) {
            EXPECT_TRUE(on_edge || channel == code) << x << ": " << channel << ", expected " << code;
        }
        different += on_edge ? 1 : 0;
    }
    EXPECT_LE(different, 4);
    EXPECT_EQ(result.image(0, 0), (CodeRGB{0, 0, 0}));
    EXPECT_EQ(result.image(kSteps - 1, 0), (CodeRGB{255, 255, 255}));
    EXPECT_EQ(result.report.gamut.outside, 0);
}

// All 256 codes, as linear light of a display: each comes back as itself through every dither.
TEST(Develop, EveryCodeSurvivesTheChain) {
    Image<XYZ> scene(256, 2);
    for (int code = 0; code < 256; ++code) {
        const auto linear = static_cast<float>(decode(SrgbTransfer{}, code / 255.0));
        scene(code, 0) = scene_xyz({linear, linear, linear}, 80.0);
        scene(code, 1) = scene_xyz({1.0f, 1.0f, 1.0f}, 80.0);
    }
    const DevelopResult result = develop(scene, {.tone_mapper = MaxToWhite{}, .dither = NoDither{}}, 1);
    for (int code = 0; code < 256; ++code) {
        const auto byte = static_cast<std::uint8_t>(code);
        EXPECT_EQ(result.image(code, 0), (CodeRGB{byte, byte, byte}));
        EXPECT_EQ(result.image(code, 1), (CodeRGB{255, 255, 255}));
    }
}

// A constant scene comes out of the default pipeline at the key: key/(1 + key), encoded.
TEST(Develop, DefaultPipelineShowsAConstantAtTheKey) {
    Image<XYZ> scene(64, 64);
    for (XYZ& pixel : scene.pixels()) pixel = scene_xyz({1.0f, 1.0f, 1.0f}, 3000.0);
    const DevelopResult result = develop(scene, {}, 0);
    double sum = 0.0;
    for (const CodeRGB& pixel : result.image.pixels()) sum += pixel.g;
    EXPECT_NEAR(sum / (64.0 * 64.0), 255.0 * encode(SrgbTransfer{}, 0.18 / 1.18), 1e-3);
    EXPECT_NEAR(result.report.luminance.log_average_cdm2, 3000.0, 1e-3);
}

TEST(Develop, PrimariesComeOutPure) {
    Image<XYZ> scene(4, 1);
    scene(0, 0) = scene_xyz({1.0f, 0.0f, 0.0f}, 10.0);
    scene(1, 0) = scene_xyz({0.0f, 1.0f, 0.0f}, 10.0);
    scene(2, 0) = scene_xyz({0.0f, 0.0f, 1.0f}, 10.0);
    scene(3, 0) = scene_xyz({1.0f, 1.0f, 1.0f}, 10.0);
    const DevelopResult result = develop(scene, {.tone_mapper = MaxToWhite{}, .dither = NoDither{}}, 1);
    EXPECT_EQ(result.image(0, 0), (CodeRGB{255, 0, 0}));
    EXPECT_EQ(result.image(1, 0), (CodeRGB{0, 255, 0}));
    EXPECT_EQ(result.image(2, 0), (CodeRGB{0, 0, 255}));
    EXPECT_EQ(result.image(3, 0), (CodeRGB{255, 255, 255}));
    EXPECT_EQ(result.report.gamut.outside, 0);
}

TEST(Develop, ReportsColoursThatTheDisplayCannotShow) {
    Image<XYZ> scene(3, 1);
    scene(0, 0) = scene_xyz({1.0f, -0.25f, 0.5f}, 10.0);
    scene(1, 0) = scene_xyz({0.5f, 0.5f, 0.5f}, 10.0);
    scene(2, 0) = scene_xyz({1.0f, 1.0f, 1.0f}, 10.0);
    const DevelopResult result = develop(scene, {.tone_mapper = MaxToWhite{}, .dither = NoDither{}}, 1);
    EXPECT_EQ(result.report.gamut.outside, 1);
    EXPECT_NEAR(result.report.gamut.largest_excess, 0.25f, 1e-6f);
    EXPECT_EQ(result.image(0, 0), (CodeRGB{255, 0, 188}));
}

// Bad pixels, through every operator: NaN and negative ones black, infinite ones white, all reported, others as before.
TEST(Develop, BadPixelsAreDefinedAndReported) {
    for_each_alternative<ToneMapper>([](const auto& tone_mapper) {
        const Pipeline pipeline{.tone_mapper = tone_mapper, .dither = NoDither{}};
        const Image<XYZ> clean = smooth_scene(64, 64);
        Image<XYZ> scene = clean;
        scene(10, 20) = {kNan, kNan, kNan};
        scene(11, 20) = {1.0f, -1.0f, 1.0f};
        scene(12, 20) = {kInf, kInf, kInf};
        const DevelopResult before = develop(clean, pipeline, 1);
        const DevelopResult after = develop(scene, pipeline, 1);
        EXPECT_EQ(after.image(10, 20), (CodeRGB{0, 0, 0}));
        EXPECT_EQ(after.image(11, 20), (CodeRGB{0, 0, 0}));
        EXPECT_EQ(after.image(12, 20), (CodeRGB{255, 255, 255}));
        EXPECT_EQ(after.report.luminance.counts.bad(), 3);
        EXPECT_EQ(after.report.luminance.first_bad_px, std::make_pair(10, 20));
        EXPECT_EQ(after.report.gamut.nan, 0);
        for (std::size_t i = 0; i < clean.pixels().size(); ++i) {
            if (i >= 20 * 64 + 10 && i <= 20 * 64 + 12) continue;
            ASSERT_LE(std::abs(after.image.pixels()[i].g - before.image.pixels()[i].g), 2) << i;
        }
    });
}

// Of operators for which the unit cancels.
TEST(Develop, PictureDoesNotDependOnTheUnit) {
    for_each_alternative<ToneMapper>([](const auto& tone_mapper) {
        if (tone_mapper.kTraits.unit == UnitOfLuminance::absolute) return;
        const Pipeline pipeline{.tone_mapper = tone_mapper, .dither = NoDither{}};
        const Image<XYZ> scene = random_scene(64, 64, 81);
        Image<XYZ> other = scene;
        for (XYZ& pixel : other.pixels()) pixel = 0x1p-40f * pixel;  // about 1e-12, exact
        EXPECT_EQ(develop(other, pipeline, 1).image, develop(scene, pipeline, 1).image);
    });
}

TEST(Develop, SameResultForEveryNumberOfThreads) {
    for_each_alternative<ToneMapper>([](const auto& tone_mapper) {
        for_each_alternative<Dither>([&](const auto& dither) {
            const Pipeline pipeline{.tone_mapper = tone_mapper, .dither = dither};
            const Image<XYZ> scene = random_scene(509, 251, 82);
            const DevelopResult one = develop(scene, pipeline, 1);
            for (const int threads : {2, 3, 8, 0}) {
                const DevelopResult other = develop(scene, pipeline, threads);
                EXPECT_EQ(other.image, one.image) << threads;
                EXPECT_EQ(other.report, one.report) << threads;
            }
        });
    });
}

TEST(Develop, AnySizeAndAllBlack) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 4099}, {4099, 1}}) {
        const DevelopResult black = develop(Image<XYZ>(width, height), {}, 0);
        EXPECT_TRUE(std::all_of(black.image.pixels().begin(), black.image.pixels().end(),
                                [](const CodeRGB& pixel) { return pixel == CodeRGB{}; }));
        EXPECT_EQ(develop(random_scene(width, height, 83), {}, 0).report.luminance.counts.bad(), 0);
    }
}

// Bloom, then vision, then the tone curve: as by hand.
TEST(Develop, BloomAndVisionComeBeforeTheToneCurve) {
    Image<XYZ> scene = random_scene(61, 47, 84);
    scene(7, 9) = {kNan, kNan, kNan};
    Pipeline pipeline{.bloom = QuarticBloom{}, .vision = HumanVision{}, .dither = NoDither{}};
    const DevelopResult result = develop(scene, pipeline, 2);
    const Image<XYZ> bloomed = add_bloom(pipeline.bloom, scene.view(), 1);
    const Image<XYZ> seen = see(pipeline.vision, bloomed.view(), 1);
    pipeline.bloom = NoBloom{};
    pipeline.vision = NoVision{};
    const DevelopResult by_hand = develop(seen, pipeline, 1);
    EXPECT_EQ(result.image, by_hand.image);
    EXPECT_EQ(result.report, by_hand.report);
    EXPECT_EQ(result.report.luminance.counts.nan, 1);
    EXPECT_NE(result.image, develop(scene, pipeline, 1).image);
}

// Stretches of rows, handed on from stage to stage: the same as whole pictures, one stage after the other.
TEST(Develop, IsItsStagesOneAfterTheOther) {
    Image<XYZ> scene = random_scene(2500, 9, 85);
    scene(2100, 4) = {kNan, kNan, kNan};
    for (const Dither& dither : {Dither(BlueNoise{}), Dither(FloydSteinberg{}), Dither(FloydSteinberg{kHilbertScan})}) {
        for (const ToneMapper& mapper :
             {ToneMapper(ReinhardGlobal{}), ToneMapper(MaxToWhite{}), ToneMapper(Durand{})}) {
            const Pipeline pipeline{.tone_mapper = mapper, .dither = dither};
            const DevelopResult result = develop(scene, pipeline, 2);
            const XYZd white = shown_as_white(pipeline.scene_white, pipeline.display);
            const XYZ narrow = {static_cast<float>(white.x), static_cast<float>(white.y), static_cast<float>(white.z)};
            const ToneMapResult mapped = tone_map({mapper}, scene.view(), narrow, 1);
            Image<RGB> encoded(scene.width(), scene.height());
            display_rgb(rgb_from_xyz(pipeline.display), mapped.image.pixels(), encoded.pixels());
            GamutCounts counts = map_gamut(pipeline.gamut, display_gamut(pipeline.display), encoded.pixels());
            counts.uncoded = DisplayEncoder(pipeline.display, transfer_of(pipeline))(encoded.pixels());
            EXPECT_EQ(result.image, quantize(dither, std::as_const(encoded).view(), {}, 1)) << to_text(pipeline);
            EXPECT_EQ(result.report.gamut, counts) << to_text(pipeline);
            EXPECT_EQ(result.report.luminance, mapped.statistics) << to_text(pipeline);
        }
    }
}

TEST(Develop, RejectsWhatItCannotDo) {
    EXPECT_THROW((void)develop(Image<XYZ>(), {}, 1), std::invalid_argument);
    EXPECT_THROW((void)develop(Image<XYZ>(1, 1), {.tone_mapper = ReinhardGlobal{-1.0f}}, 1), std::invalid_argument);
    EXPECT_THROW((void)develop(Image<XYZ>(1, 1), {.bits = 17}, 1), std::invalid_argument);
    EXPECT_THROW((void)develop(Image<XYZ>(1, 1), {}, -1), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
