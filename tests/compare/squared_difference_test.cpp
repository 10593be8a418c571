// Squared differences, and how much of them is noise.

#include "compare/squared_difference.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

#include "compare_fixture.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
const ViewingConditions kViewing{.white = d65(), .white_luminance_cdm2 = 100.0};

SquaredDifference found(const ComparedPicture& a, const ComparedPicture& b) {
    return squared_difference(a, b, kViewing, 0);
}

TEST(SquaredDifference, OfGreysIsThatOfTheirShareOfWhite) {
    const SquaredDifference greys = found(constant(20.0 * d65()), constant(50.0 * d65()));
    EXPECT_EQ(greys.pixels, 35);
    EXPECT_NEAR(greys.mean_squared, 0.09, 1e-7);
    EXPECT_NEAR(greys.relative, 0.09 / (0.04 + 0.01), 1e-6);
    EXPECT_EQ(greys.parts, std::nullopt);
}

// Red (1, 0, 0) against (0.5, 0, 0.2) of Rec. 709.
TEST(SquaredDifference, RelativeErrorsAreThoseOfRgb) {
    const Matrix3 xyz_from_709 = xyz_from_rgb(rgb_space("Rec709"));
    const auto color = [&](double r, double g, double b) {
        const auto xyz = xyz_from_709 * std::array<double, 3>{r, g, b};
        return constant(100.0 * XYZd{xyz[0], xyz[1], xyz[2]});
    };
    const double expected = (0.25 / (1.0 + 0.01) + 0.04 / 0.01) / 3.0;
    EXPECT_NEAR(found(color(1.0, 0.0, 0.0), color(0.5, 0.0, 0.2)).relative, expected, 1e-5);
}

TEST(SquaredDifference, IsOfPixelsAsTheyAre) {
    EXPECT_NEAR(found(constant(-50.0 * d65()), constant(300.0 * d65())).mean_squared, 3.5 * 3.5, 1e-5);
}

ComparedPicture with_error(ComparedPicture picture, const XYZ& error, KnownNoise noise = KnownNoise::xyz) {
    picture.noise = noise;
    picture.standard_error = Image<XYZ>(picture.xyz.width(), picture.xyz.height());
    for (XYZ& pixel : picture.standard_error.pixels()) pixel = error;
    return picture;
}

// Weights of greys of 20 and 30 % of white: 1 / (0.25^2 + 0.01).
TEST(SquaredDifference, IsNoiseAndBias) {
    const XYZ few = narrowed(3.0 * d65()), many = narrowed(4.0 * d65());
    const ComparedPicture a = with_error(constant(20.0 * d65()), few), b = with_error(constant(30.0 * d65()), many);
    const std::optional<NoiseAndBias> parts = found(a, b).parts;
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->pixels, 35);
    EXPECT_NEAR(parts->mean_squared, 0.01 / 0.0725, 1e-7);
    EXPECT_NEAR(parts->noise, 0.0025 / 0.0725, 1e-8);
    EXPECT_NEAR(parts->noise_share(), 0.25, 1e-6);
    EXPECT_NEAR(parts->bias_share(), 0.75, 1e-6);
    EXPECT_NEAR(parts->bias_standard_error, 0.0, 1e-8);  // every pixel tells the same
}

TEST(SquaredDifference, WhatOneKnowsOfLuminanceAloneIsOfLuminance) {
    const ComparedPicture a = with_error(constant(20.0 * d65()), {kNaN, 3.0f, 0.0f}, KnownNoise::luminance);
    ComparedPicture b = with_error(constant(30.0 * d65()), narrowed(4.0 * d65()));
    for (XYZ& pixel : b.xyz.pixels()) pixel.x = 900.0f;
    const std::optional<NoiseAndBias> parts = found(a, b).parts;
    ASSERT_TRUE(parts);
    EXPECT_EQ(parts->components, KnownNoise::luminance);
    EXPECT_NEAR(parts->mean_squared, 0.01 / 0.0725, 1e-7);
    EXPECT_NEAR(parts->noise, 0.0025 / 0.0725, 1e-8);
}

TEST(SquaredDifference, PixelsOfUnknownNoiseHaveNoPartInIt) {
    ComparedPicture a = with_error(constant(20.0 * d65()), {1.0f, 1.0f, 1.0f}), b = a;
    a.standard_error(2, 2).x = kNaN;
    b.xyz(2, 2).y = 5000.0f;
    ASSERT_TRUE(found(a, b).parts);
    EXPECT_EQ(found(a, b).parts->pixels, 34);
    EXPECT_EQ(found(a, b).parts->mean_squared, 0.0);
    EXPECT_EQ(found(a, b).parts->noise_share(), 0.0);
    EXPECT_GT(found(a, b).mean_squared, 1.0);
    for (XYZ& pixel : a.standard_error.pixels()) pixel.y = kNaN;
    EXPECT_EQ(found(a, b).parts, std::nullopt);
    EXPECT_EQ(found(constant(d65()), b).parts, std::nullopt);
}

// The estimate of the bias is off by four of its standard errors once in 16000 seeds; these are fixed.
TEST(SquaredDifference, TwoFilmsOfOneSceneDifferByNoiseAlone) {
    for (const FilmVariance variance : {FilmVariance::luminance, FilmVariance::xyz}) {
        const std::optional<NoiseAndBias> parts =
            found(noisy_film(1, 0.0f, variance, 8), noisy_film(2, 0.0f, variance, 8)).parts;
        ASSERT_TRUE(parts);
        EXPECT_EQ(parts->components, variance == FilmVariance::xyz ? KnownNoise::xyz : KnownNoise::luminance);
        // Weights are 1 / (0.3^2 + 0.01), and some 1.5 % more as m is noisy and they are convex in it.
        EXPECT_NEAR(parts->mean_squared, 1.015 * 10.0 * 2.0 * 0.09 / 8.0, 0.02 * 0.225);
        EXPECT_NEAR(parts->bias, 0.0, 4.0 * parts->bias_standard_error);
        EXPECT_LT(parts->bias_share_standard_error(), 0.02);
        EXPECT_NEAR(parts->noise_share(), 1.0, 4.0 * parts->bias_share_standard_error());
    }
}

// 3 cd/m^2 are 0.03 of white: 3.8 % of the squared difference. Weights are 1 / (0.315^2 + 0.01).
TEST(SquaredDifference, ABiasBelowTheNoiseIsFound) {
    const std::optional<NoiseAndBias> parts =
        found(noisy_film(1, 0.0f, FilmVariance::xyz, 8), noisy_film(2, 3.0f, FilmVariance::xyz, 8)).parts;
    ASSERT_TRUE(parts);
    EXPECT_NEAR(parts->bias, 0.0009 / 0.1092, 4.0 * parts->bias_standard_error);
    EXPECT_GT(parts->bias, 2.0 * parts->bias_standard_error);
}

}  // namespace
}  // namespace emulsion
