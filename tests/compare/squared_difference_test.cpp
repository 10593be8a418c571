// Squared differences, and how much of them is noise.

#include "compare/squared_difference.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "compare_fixture.h"
#include "film/film.h"
#include "film/film_layers.h"
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

/// A film of samples that are exponentially distributed about a grey of 30 cd/m^2 (variances 900), and of a bias.
ComparedPicture noisy_film(std::uint64_t seed, float bias, FilmVariance variance, int samples) {
    Film film({.width_px = 200, .height_px = 150, .variance = variance});
    FilmTile tile = film.make_tile(film.bounds());
    Pcg32 random(seed);
    const XYZ white = narrowed(d65());
    for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 200; ++x) {
            for (int i = 0; i < samples; ++i) {
                const float luminance = bias - 30.0f * std::log(1.0f - random.next_float());
                tile.add(x, y, luminance * white, 1.0f);
            }
        }
    }
    film.merge(tile);
    FilmImage image;
    static_cast<FilmPicture&>(image) = picture_of(film);
    return compared_picture(std::move(image));
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

TEST(ComparedPicture, PixelsOfOneSampleTellNoNoise) {
    const ComparedPicture film = noisy_film(1, 0.0f, FilmVariance::xyz, 1);
    EXPECT_EQ(film.noise, KnownNoise::xyz);
    EXPECT_TRUE(std::isnan(film.standard_error(7, 7).y));
    EXPECT_EQ(found(film, noisy_film(2, 0.0f, FilmVariance::xyz, 1)).parts, std::nullopt);
}

TEST(ComparedPicture, TakesNoiseInTheFilesUnitAndTheObserverFromTheHeader) {
    FilmImage image;
    image.xyz = Image<XYZ>(2, 1);
    image.data_window = {0, 0, 2, 1};
    image.width_px = 2;
    image.height_px = 1;
    image.floats.push_back({"standard-error.Y", Image<float>(2, 1)});
    image.floats[0].values(1, 0) = 3.0f;
    image.white_luminance_cdm2 = 8.0;
    image.metadata.film = "variance=luminance observer=cie-1964-10deg camera=none";
    const ComparedPicture picture = compared_picture(image);
    EXPECT_EQ(picture.noise, KnownNoise::luminance);
    EXPECT_EQ(picture.standard_error(1, 0), (XYZ{0.0f, 24.0f, 0.0f}));
    EXPECT_EQ(picture.observer, "cie-1964-10deg");
    EXPECT_EQ(picture.seeds, std::vector<std::uint64_t>{});
    image.metadata.renderer_version = "test 1";
    image.metadata.seed = 5;
    EXPECT_EQ(compared_picture(image).seeds, std::vector<std::uint64_t>{5});
}

}  // namespace
}  // namespace emulsion
