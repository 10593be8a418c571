#include "tonemap/reinhard_global.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};

/// The operator's curve: adapted to the key, so that L = Y.
double curve(double scaled_luminance, float white) {
    constexpr float kKey = 0.25f;
    return PreparedOperator(ReinhardGlobal{kKey, white}, row_of_greys({1.0f}), double{kKey})(scaled_luminance);
}

// Eq. 3 and 4 by hand: L/(1 + L), and L (1 + L/white^2)/(1 + L).
TEST(ReinhardGlobal, CurveHasThePapersValues) {
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    EXPECT_DOUBLE_EQ(curve(0.18, kInfinite), 0.18 / 1.18);
    EXPECT_DOUBLE_EQ(curve(1.0, kInfinite), 0.5);
    EXPECT_DOUBLE_EQ(curve(3.0, kInfinite), 0.75);
    EXPECT_EQ(curve(0.0, kInfinite), 0.0);
    EXPECT_DOUBLE_EQ(curve(1.0, 2.0f), 0.625);     // 1 (1 + 1/4)/2
    EXPECT_DOUBLE_EQ(curve(0.5, 2.0f), 0.375);     // 0.5 (1 + 1/8)/1.5
    EXPECT_DOUBLE_EQ(curve(6.0, 2.0f), 15.0 / 7);  // 6 (1 + 6/4)/7
}

// Of the operator itself, in double precision, by the scale that every operator has. The quotient and the product
// round: of 49 there is no scale by which it would come to 1 in double precision.
TEST(ReinhardGlobal, WhiteMapsToOneExactly) {
    int whites = 0;
    for (double exact_white = 1e-8; exact_white < 1e12; exact_white *= 1.3683) {
        const auto white = static_cast<float>(exact_white);
        const double displayed = curve(double{white}, white);
        EXPECT_EQ(static_cast<float>(displayed), 1.0f) << white;
        EXPECT_NEAR(displayed, 1.0, 4e-16) << white;
        ++whites;
    }
    EXPECT_EQ(whites, 147);
}

TEST(ReinhardGlobal, CurveRisesForEveryWhite) {
    for (const float white : {0.1f, 0.5f, 1.0f, 3.0f, 100.0f, std::numeric_limits<float>::infinity()}) {
        double previous = -1.0;
        for (double scaled = 0.0; scaled < 1e6; scaled = scaled * 1.1 + 1e-6) {
            const double displayed = curve(scaled, white);
            EXPECT_GT(displayed, previous) << "white " << white << ", L " << scaled;
            previous = displayed;
        }
    }
}

TEST(ReinhardGlobal, ConstantPictureMapsToTheCurveAtTheKey) {
    Image<XYZ> scene(17, 5);
    for (XYZ& pixel : scene.pixels()) pixel = grey(1234.5f);
    for (const float key : {0.045f, 0.18f, 0.72f}) {
        const ToneMapResult result = tone_map({ReinhardGlobal{key}}, scene.view(), kWhite, 1);
        for (const XYZ& pixel : result.image.pixels()) EXPECT_NEAR(pixel.y, key / (1.0f + key), 1e-4f * key);
    }
}

// The log-average is 10 cd/m^2: 1 and 100 are scaled to 0.018 and 1.8.
TEST(ReinhardGlobal, PictureHasThePapersValues) {
    Image<XYZ> scene(2, 1);
    scene(0, 0) = {0.5f, 1.0f, 0.25f};
    scene(1, 0) = {200.0f, 100.0f, 50.0f};
    const Image<XYZ> mapped = tone_map({ReinhardGlobal{0.18f, 1.8f}}, scene.view(), kWhite, 1).image;
    const float dark = 0.018f * (1.0f + 0.018f / 3.24f) / 1.018f;
    EXPECT_NEAR(mapped(0, 0).y, dark, 1e-4f * dark);
    EXPECT_NEAR(mapped(0, 0).x, 0.5f * dark, 1e-4f * dark);
    EXPECT_NEAR(mapped(0, 0).z, 0.25f * dark, 1e-4f * dark);
    EXPECT_NEAR(mapped(1, 0).y, 1.0f, 1e-4f);
    EXPECT_NEAR(mapped(1, 0).x, 2.0f, 2e-4f);
}

// By hand: log2 of least, average and most are 0, 3 and 8 of 1, 2^1, 2^8: 0.18 * 4^((6 - 8)/8). Quantiles are to 3e-5.
TEST(ReinhardGlobal, KeyIsEstimatedFromTheRange) {
    const auto key = [](const Image<XYZ>& scene) { return photographic_key(SceneLuminance(scene.view(), 1)); };
    EXPECT_NEAR(key(row_of_greys({1.0f, 2.0f, 256.0f})), 0.18 * std::pow(4.0, -0.25), 1e-5);
    EXPECT_NEAR(key(row_of_greys({1.0f, 16.0f, 256.0f})), 0.18, 1e-5);
    EXPECT_NEAR(key(row_of_greys({1.0f, 256.0f, 256.0f, 256.0f})), 0.18 * 2.0, 1e-5);
    EXPECT_EQ(key(row_of_greys({7.0f, 7.0f})), 0.18);
}

// By hand: 1.5 * 2^(8 - 5), 1.5 * 2^(10 - 5); of one octave it would be 1.5 / 16, below the key.
TEST(ReinhardGlobal, WhiteIsEstimatedFromTheRange) {
    const auto white = [](const Image<XYZ>& scene, double key) {
        return photographic_white(SceneLuminance(scene.view(), 1), key);
    };
    EXPECT_NEAR(white(row_of_greys({1.0f, 2.0f, 256.0f}), 0.18), 12.0, 12.0 * 1e-4);
    EXPECT_NEAR(white(row_of_greys({0.25f, 2.0f, 256.0f}), 0.18), 48.0, 48.0 * 1e-4);
    EXPECT_EQ(white(row_of_greys({1.0f, 2.0f}), 0.18), 0.18);
    EXPECT_EQ(white(row_of_greys({7.0f, 7.0f}), 0.5), 0.5);
}

// 1000 pixels of 1 to 2^10 cd/m^2, and at either end 10 far off: 1.5 * 2^(10 - 5), not 1.5 * 2^(20 - 5).
TEST(ReinhardGlobal, EstimatesLeaveOutAHundredthAtEitherEnd) {
    std::vector<float> luminances;
    for (int i = 0; i < 1000; ++i) luminances.push_back(std::exp2(static_cast<float>(i) / 99.9f));
    for (int i = 0; i < 10; ++i) {
        luminances.push_back(0x1p-5f);
        luminances.push_back(0x1p15f);
    }
    const SceneLuminance luminance(row_of_greys(luminances).view(), 1);
    EXPECT_NEAR(photographic_white(luminance, 0.18), 48.0, 0.05 * 48.0);
    EXPECT_NEAR(photographic_key(luminance), 0.18, 0.01 * 0.18);
}

TEST(ReinhardGlobal, AutomaticWhiteIsThatOfThePaperOf2003) {
    const PreparedOperator displayed(ReinhardGlobal{0.18f, ReinhardGlobal::kAutoWhite},
                                     row_of_greys({1.0f, 2.0f, 256.0f}), 8.0);
    EXPECT_NEAR(displayed(12.0 * 8.0 / 0.18), 1.0, 1e-4);  // L = 12
    EXPECT_NEAR(displayed(8.0), 0.18 * (1.0 + 0.18 / 144.0) / 1.18, 1e-7);
}

// Log-average 10: with a key of 0.18, 1000 is scaled to 18.
TEST(ReinhardGlobal, WhiteMayBeThatOfTheLargestLuminance) {
    const PreparedOperator displayed(ReinhardGlobal{0.18f, ReinhardGlobal::kMaxWhite}, row_of_greys({0.1f, 1000.0f}),
                                     10.0);
    EXPECT_NEAR(displayed(1000.0), 1.0, 1e-14);
    EXPECT_NEAR(displayed(10.0), 0.18 * (1.0 + 0.18 / 324.0) / 1.18, 1e-8);
    const PreparedOperator automatic(ReinhardGlobal{0.0f, ReinhardGlobal::kMaxWhite},
                                     row_of_greys({1.0f, 2.0f, 256.0f}), 8.0);
    const double key = 0.18 * std::pow(4.0, -0.25);
    EXPECT_NEAR(automatic(256.0), 1.0, 1e-14);
    EXPECT_NEAR(automatic(8.0), key * (1.0 + key / std::pow(32.0 * key, 2)) / (1.0 + key), 1e-5);
}

TEST(ReinhardGlobal, AutomaticParametersAreWords) {
    EXPECT_EQ(to_text(ReinhardGlobal{0.0f, ReinhardGlobal::kAutoWhite}), "reinhard-global:key=auto,white=auto");
    EXPECT_EQ(parse_named<ToneMapper>("reinhard-global:key=auto,white=Auto", "tonemap"),
              ToneMapper(ReinhardGlobal{0.0f, ReinhardGlobal::kAutoWhite}));
    EXPECT_EQ(parse_named<ToneMapper>("reinhard-global:white=max", "tonemap"),
              ToneMapper(ReinhardGlobal{0.18f, ReinhardGlobal::kMaxWhite}));
}

TEST(ReinhardGlobal, RejectsParametersOutOfRange) {
    const Image<XYZ> scene(1, 1);
    const auto map_with = [&](const ReinhardGlobal& mapper) {
        return [&scene, mapper] { (void)tone_map({mapper}, scene.view(), kWhite, 1); };
    };
    EXPECT_THAT(map_with({-0.5f, 1.0f}),
                ThrowsMessage<std::invalid_argument>(HasSubstr("key = -0.5: must be auto or in (0, inf)")));
    EXPECT_THAT(map_with({0.18f, -0.5f}),
                ThrowsMessage<std::invalid_argument>(HasSubstr("white = -0.5: must be auto, max or in (0, inf]")));
    EXPECT_THAT([] { (void)parse_named<ToneMapper>("reinhard-global:white=-1", "tonemap"); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("white = -1: must be auto, max or in (0, inf]")));
    EXPECT_THAT(map_with({std::numeric_limits<float>::quiet_NaN(), 1.0f}),
                ThrowsMessage<std::invalid_argument>(HasSubstr("key = nan")));
}

}  // namespace
}  // namespace emulsion
