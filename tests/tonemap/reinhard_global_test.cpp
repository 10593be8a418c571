#include "tonemap/reinhard_global.h"

#include <cmath>
#include <limits>
#include <stdexcept>

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

// Eq. 3 and 4 by hand: L/(1 + L), and L (1 + L/white^2)/(1 + L).
TEST(ReinhardGlobal, CurveHasThePapersValues) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    EXPECT_DOUBLE_EQ(photographic_curve(0.18, kInfinite), 0.18 / 1.18);
    EXPECT_DOUBLE_EQ(photographic_curve(1.0, kInfinite), 0.5);
    EXPECT_DOUBLE_EQ(photographic_curve(3.0, kInfinite), 0.75);
    EXPECT_EQ(photographic_curve(0.0, kInfinite), 0.0);
    EXPECT_DOUBLE_EQ(photographic_curve(1.0, 2.0), 0.625);     // 1 (1 + 1/4)/2
    EXPECT_DOUBLE_EQ(photographic_curve(0.5, 2.0), 0.375);     // 0.5 (1 + 1/8)/1.5
    EXPECT_DOUBLE_EQ(photographic_curve(6.0, 2.0), 15.0 / 7);  // 6 (1 + 6/4)/7
}

TEST(ReinhardGlobal, WhiteMapsToOneExactly) {
    for (double white = 1e-3; white < 1e6; white *= 1.37) {
        EXPECT_EQ(photographic_curve(white, white), 1.0) << white;
    }
}

TEST(ReinhardGlobal, CurveRisesForEveryWhite) {
    for (const double white : {0.1, 0.5, 1.0, 3.0, 100.0, std::numeric_limits<double>::infinity()}) {
        double previous = -1.0;
        for (double scaled = 0.0; scaled < 1e6; scaled = scaled * 1.1 + 1e-6) {
            const double displayed = photographic_curve(scaled, white);
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

// Eq. 4 of 2003 by hand: log2 of least, average and most are 0, 3 and 8 of 1, 2^1, 2^8: 0.18 * 4^((6 - 8)/8).
TEST(ReinhardGlobal, KeyIsEstimatedFromTheRange) {
    const auto key = [](const Image<XYZ>& scene) { return photographic_key(SceneLuminance(scene.view(), 1)); };
    EXPECT_NEAR(key(row_of_greys({1.0f, 2.0f, 256.0f})), 0.18 * std::pow(4.0, -0.25), 1e-14);
    EXPECT_NEAR(key(row_of_greys({1.0f, 16.0f, 256.0f})), 0.18, 1e-14);
    EXPECT_NEAR(key(row_of_greys({1.0f, 256.0f, 256.0f, 256.0f})), 0.18 * 2.0, 1e-14);
    EXPECT_EQ(key(row_of_greys({7.0f, 7.0f})), 0.18);
}

// Log-average 10: with a key of 0.18, 1000 is scaled to 18, which an automatic white takes.
TEST(ReinhardGlobal, AutomaticWhiteIsTheLargestLuminance) {
    const PreparedOperator displayed(ReinhardGlobal{0.18f, 0.0f}, row_of_greys({0.1f, 1000.0f}), 10.0);
    EXPECT_NEAR(displayed(1000.0), 1.0, 1e-14);
    EXPECT_NEAR(displayed(10.0), 0.18 * (1.0 + 0.18 / 324.0) / 1.18, 1e-8);
    const PreparedOperator automatic(ReinhardGlobal{0.0f, 0.0f}, row_of_greys({1.0f, 2.0f, 256.0f}), 8.0);
    const double key = 0.18 * std::pow(4.0, -0.25);
    EXPECT_NEAR(automatic(256.0), 1.0, 1e-14);
    EXPECT_NEAR(automatic(8.0), key * (1.0 + key / std::pow(32.0 * key, 2)) / (1.0 + key), 1e-12);
}

TEST(ReinhardGlobal, AutomaticParametersAreWords) {
    EXPECT_EQ(to_text(ReinhardGlobal{0.0f, 0.0f}), "reinhard-global:key=auto,white=auto");
    EXPECT_EQ(parse_named<ToneMapper>("reinhard-global:key=auto,white=Auto", "tonemap"),
              ToneMapper(ReinhardGlobal{0.0f, 0.0f}));
}

TEST(ReinhardGlobal, RejectsParametersOutOfRange) {
    const Image<XYZ> scene(1, 1);
    const auto map_with = [&](const ReinhardGlobal& mapper) {
        return [&scene, mapper] { (void)tone_map({mapper}, scene.view(), kWhite, 1); };
    };
    EXPECT_THAT(map_with({-0.5f, 1.0f}),
                ThrowsMessage<std::invalid_argument>(HasSubstr("key = -0.5: must be in [0, inf)")));
    EXPECT_THAT(map_with({0.18f, -1.0f}), ThrowsMessage<std::invalid_argument>(HasSubstr("white = -1")));
    EXPECT_THAT(map_with({std::numeric_limits<float>::quiet_NaN(), 1.0f}),
                ThrowsMessage<std::invalid_argument>(HasSubstr("key = nan")));
}

}  // namespace
}  // namespace emulsion
