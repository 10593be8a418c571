#include "compare/pixel_choice.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compare/compare.h"
#include "film/exr_file.h"
#include "film/exr_layers.h"
#include "support/temporary_folder.h"

namespace emulsion::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Optional;
using ::testing::Pair;
using ::testing::StartsWith;

constexpr float kInf = std::numeric_limits<float>::infinity();

/// A ramp of greys and colours, in no place a half, in a window at (10, 20) of a frame.
FilmPicture smooth_picture() {
    FilmPicture picture{.xyz = Image<XYZ>(32, 16), .data_window = {10, 20, 42, 36}, .width_px = 64, .height_px = 48};
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 32; ++x) {
            const float luminance = 1.7f * std::exp2(0.37f * static_cast<float>(x)),
                        red = 0.01f * static_cast<float>(y);
            picture.xyz(x, y) = {luminance * (0.95f + red), luminance, luminance * (1.09f - red)};
        }
    }
    return picture;
}

HalfLoss loss_of(const FilmPicture& picture, const ExrOptions& options = {}) {
    return half_loss(picture, options, cie_1931_2deg());
}
PixelDecision decision_of(const FilmPicture& picture, const ErrorBudget& budget = {}) {
    return decide_pixels(loss_of(picture), budget);
}

TEST(PixelChoice, IsReadFromItsText) {
    EXPECT_EQ(parse_pixel_choice("half"), PixelChoice(PixelType::half));
    EXPECT_EQ(parse_pixel_choice("float"), PixelChoice(PixelType::float32));
    EXPECT_EQ(parse_pixel_choice("auto"), PixelChoice(AutoPixels{}));
    EXPECT_EQ(parse_pixel_choice("auto:0.1,2"), PixelChoice(AutoPixels{{0.1, 2.0}}));
    EXPECT_EQ(parse_pixel_choice("Half"), PixelChoice(PixelType::half)) << "as other names";
    for (const char* wrong : {"", "halves", "float32", "autos", "auto:"}) {
        EXPECT_THROW((void)parse_pixel_choice(wrong), std::invalid_argument) << wrong;
    }
}

TEST(PixelChoice, ASmoothPictureIsHalf) {
    const PixelDecision decision = decision_of(smooth_picture());
    EXPECT_EQ(decision.type, PixelType::half);
    EXPECT_THAT(decision.reason, AllOf(StartsWith("half: dE00 0.0"), HasSubstr("within 1 and 3; float would take 2x")));
}

// Half's 11 bits move luminance by 2^-12 of itself on average or less, which is L* by 100 * 2^-12 / 3 at most.
TEST(PixelChoice, TheErrorIsThatOfElevenBits) {
    const HalfLoss loss = loss_of(smooth_picture());
    EXPECT_GT(loss.ciede2000.mean, 0.001);
    EXPECT_LT(loss.ciede2000.mean, 0.05);
    EXPECT_LT(loss.ciede2000.p99, 0.2);
    EXPECT_EQ(loss.ciede2000.pixels, 32 * 16);
}

/// The error is measured on what the writer's two files hold, in any space: so `emulsion compare` finds the same.
TEST(PixelChoice, IsWhatTheFilesDifferBy) {
    const TemporaryFolder folder;
    const FilmPicture picture = smooth_picture();
    for (const char* space : {"XYZ", "sRGB", "ACEScg_AP1"}) {
        const auto written = [&](PixelType type) {
            const ExrOptions options{.space = space, .pixel_type = type, .white_luminance_cdm2 = 0.25};
            write_exr(folder.file("a.exr"), picture, {}, options);
            return compared_picture(read_exr(folder.file("a.exr")));
        };
        const Comparison files = compare(written(PixelType::float32), written(PixelType::half), {});
        const HalfLoss loss = loss_of(picture, {.space = space, .white_luminance_cdm2 = 0.25});
        // Read pixels are rounded to floats, cd/m^2 here and the file's unit there: 2^-24, and CIELAB's slope.
        EXPECT_NEAR(loss.ciede2000.mean, files.ciede2000.mean, 1e-4) << space;
        EXPECT_NEAR(loss.ciede2000.p99, files.ciede2000.p99, 1e-4) << space;
        EXPECT_GT(loss.ciede2000.mean, 0.001) << space;
    }
}

TEST(PixelChoice, ABudgetOfNothingIsFloat) {
    const PixelDecision decision = decision_of(smooth_picture(), {0.0, 0.0});
    EXPECT_EQ(decision.type, PixelType::float32);
    EXPECT_THAT(decision.reason, AllOf(StartsWith("float: half has dE00 0.0"), HasSubstr("asked for 0 and 0")));
    // Either limit.
    const HalfLoss loss = loss_of(smooth_picture());
    EXPECT_EQ(decide_pixels(loss, {loss.ciede2000.mean, loss.ciede2000.p99}).type, PixelType::half);
    EXPECT_EQ(decide_pixels(loss, {0.99 * loss.ciede2000.mean, 1.0}).type, PixelType::float32);
    EXPECT_EQ(decide_pixels(loss, {1.0, 0.99 * loss.ciede2000.p99}).type, PixelType::float32);
    EXPECT_THROW((void)decide_pixels(loss, {-1.0, 1.0}), std::invalid_argument);
}

// A picture of halves loses nothing, whatever the budget.
TEST(PixelChoice, WhatIsHalfAlreadyStaysSo) {
    FilmPicture picture = smooth_picture();
    picture.xyz = as_stored(picture.xyz, {.pixel_type = PixelType::half});
    EXPECT_EQ(decision_of(picture, {0.0, 0.0}).type, PixelType::half);
}

TEST(PixelChoice, WhatOverflowsIsFloat) {
    FilmPicture picture = smooth_picture();
    picture.xyz(3, 4) = {60000.0f, 60000.0f, 65505.0f};
    PixelDecision decision = decision_of(picture, {100.0, 100.0});
    EXPECT_EQ(decision.type, PixelType::float32);
    EXPECT_EQ(decision.reason, "float: half would overflow in 1 pixel, (13, 24)") << "in the frame";
    picture.xyz(31, 5).x = -70000.0f;
    decision = decision_of(picture, {100.0, 100.0});
    EXPECT_EQ(decision.reason, "float: half would overflow in 2 pixels, first at (13, 24)");
    // Within the range of X, Y and Z, and not of R.
    picture = smooth_picture();
    picture.xyz(0, 0) = {65000.0f, 40000.0f, 1000.0f};
    EXPECT_EQ(loss_of(picture).overflowing, 0);
    EXPECT_EQ(loss_of(picture, {.space = "sRGB"}).overflowing, 1);
}

// The least half above 0 is 2^-24; half of that goes to 0.
TEST(PixelChoice, WhatVanishesIsFloat) {
    FilmPicture picture = smooth_picture();
    picture.xyz(1, 0) = {0.0f, 1e-9f, 0.0f};
    const HalfLoss loss = loss_of(picture);
    EXPECT_EQ(loss.vanishing, 1);
    EXPECT_THAT(loss.first_vanishing_px, Optional(Pair(11, 20)));
    EXPECT_EQ(decide_pixels(loss, {}).reason, "float: half would make values 0 in 1 pixel, (11, 20)");
    picture.xyz(1, 0) = {0.0f, 0.0f, 0.0f};
    EXPECT_EQ(decision_of(picture).type, PixelType::half) << "0 is 0";
}

// Left out, as everywhere: half holds them as well as float does.
TEST(PixelChoice, PixelsThatAreNotFiniteDoNotDecide) {
    FilmPicture picture = smooth_picture();
    picture.xyz(2, 2).y = std::numeric_limits<float>::quiet_NaN();
    picture.xyz(3, 2).x = kInf;
    const HalfLoss loss = loss_of(picture);
    EXPECT_EQ(loss.ciede2000.pixels, 32 * 16 - 2);
    EXPECT_EQ(loss.overflowing, 0);
    EXPECT_EQ(decide_pixels(loss, {}).type, PixelType::half);
}

TEST(PixelChoice, ABlackPictureIsHalf) {
    const FilmPicture black{.xyz = Image<XYZ>(4, 4), .data_window = {0, 0, 4, 4}, .width_px = 4, .height_px = 4};
    EXPECT_EQ(decision_of(black, {0.0, 0.0}).type, PixelType::half);
}

Image<float> constant(float value) {
    Image<float> image(32, 16);
    for (float& pixel : image.pixels()) pixel = value;
    return image;
}

TEST(PixelChoice, ALayerThatHalfDamagesIsFloat) {
    const auto with_layer = [](const std::string& name, const Image<float>& values) {
        FilmPicture picture = smooth_picture();
        picture.floats = {{name, values}};
        return picture;
    };
    EXPECT_EQ(decision_of(with_layer("albedo.R", constant(0.123f))).type, PixelType::half);
    Image<float> bright = constant(0.123f);
    bright(7, 7) = 1e5f;
    EXPECT_EQ(decision_of(with_layer("albedo.R", bright)).reason, "float: half would damage the channel albedo.R");
    // In the range of subnormal numbers, 7 bits are left here.
    EXPECT_EQ(decision_of(with_layer("albedo.R", constant(3.3e-6f))).type, PixelType::float32);
    // In its dark corners only.
    Image<float> dark = constant(0.123f);
    dark(7, 7) = 3.3e-6f;
    dark(8, 7) = 1e-12f;
    EXPECT_EQ(decision_of(with_layer("albedo.R", dark)).type, PixelType::half);
    // Always float, and so no matter.
    EXPECT_EQ(decision_of(with_layer("depth.Z", constant(kInf))).type, PixelType::half);
    EXPECT_EQ(decision_of(with_layer("variance.Y", constant(1e9f))).type, PixelType::half);
}

TEST(PixelChoice, SpectralChannelsAreLayersToo) {
    FilmPicture picture = smooth_picture();
    picture.spectral = {{.centre_nm = 450.0, .width_nm = 100.0, .values = constant(0.017f)},
                        {.centre_nm = 550.0, .width_nm = 100.0, .values = constant(3.3e-6f)}};
    EXPECT_EQ(decision_of(picture).reason, "float: half would damage the channel " + spectral_channel_name(550.0));
    picture.spectral[1].values = constant(0.017f);
    EXPECT_EQ(decision_of(picture).type, PixelType::half);
}

// Of eight channels one is always float and one of whole numbers: 8 * 4 bytes over 6 * 2 + 2 * 4.
TEST(PixelChoice, CountsTheBytesOfAllChannels) {
    FilmPicture picture = smooth_picture();
    EXPECT_DOUBLE_EQ(loss_of(picture).float_bytes, 2.0);
    picture.floats = {{"albedo.R", constant(0.5f)}, {"albedo.G", constant(0.5f)}, {"depth.Z", constant(0.5f)}};
    picture.counts = {{"samples", Image<std::uint32_t>(32, 16)}};
    picture.spectral = {{.centre_nm = 450.0, .width_nm = 100.0, .values = constant(0.017f)}};
    EXPECT_DOUBLE_EQ(loss_of(picture).float_bytes, 32.0 / 20.0);
}

TEST(PixelChoice, RefusesWhatTheWriterWould) {
    FilmPicture picture = smooth_picture();
    EXPECT_THROW((void)loss_of(picture, {.space = "none such"}), std::invalid_argument);
    EXPECT_THROW((void)loss_of(picture, {.threads = -1}), std::invalid_argument);
    picture.floats = {{"albedo.R", Image<float>(3, 3)}};
    EXPECT_THROW((void)loss_of(picture), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion::testing
