// Variances and standard errors of pixels, beside the formulae that they are to obey.

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"

namespace emulsion {
namespace {

PixelVariance first_pixel_variance(const Film& film) {
    PixelVariance variance;
    film.for_each_pixel([&](std::size_t i, const PixelSums& sums) {
        if (i == 0) variance = variance_of(sums, film.setup());
    });
    return variance;
}

double squared(double value) { return value * value; }

// Weights of 1: the usual unbiased estimate, by the sum of squared deviations.
TEST(FilmVariance, IsTheUnbiasedEstimateOfPlainSamples) {
    for (const FilmVariance kind : {FilmVariance::luminance, FilmVariance::xyz}) {
        Film film({.width_px = 1, .height_px = 1, .variance = kind});
        FilmTile tile = film.make_tile(film.bounds());
        Pcg32 random(4);
        std::vector<XYZ> samples;
        for (int i = 0; i < 100; ++i) {
            samples.push_back({5.0f + random.next_float(), 1e3f * random.next_float(), 1e-3f * random.next_float()});
            tile.add(0, 0, samples.back(), 1.0f);
        }
        film.merge(tile);
        XYZd mean, variance;
        for (const XYZ& s : samples) mean = mean + 0.01 * XYZd{double{s.x}, double{s.y}, double{s.z}};
        for (const XYZ& s : samples) {
            variance = variance + (1.0 / 99.0) * XYZd{squared(double{s.x} - mean.x), squared(double{s.y} - mean.y),
                                                      squared(double{s.z} - mean.z)};
        }
        const PixelVariance found = first_pixel_variance(film);
        EXPECT_NEAR(found.variance.y, variance.y, 1e-12 * variance.y);
        EXPECT_NEAR(found.standard_error.y, std::sqrt(variance.y / 100.0), 1e-12 * std::sqrt(variance.y));
        if (kind == FilmVariance::luminance) {
            EXPECT_EQ(found.variance.x, 0.0);
            continue;
        }
        EXPECT_NEAR(found.variance.x, variance.x, 1e-12 * squared(mean.x));
        // Squares of about 1e-7, in multiples of 8.7e-19.
        EXPECT_NEAR(found.variance.z, variance.z, 1e-17);
    }
}

TEST(FilmVariance, NothingToEstimateFromIsZero) {
    Film film({.width_px = 1, .height_px = 1, .variance = FilmVariance::luminance});
    EXPECT_EQ(first_pixel_variance(film).variance.y, 0.0);
    FilmTile tile = film.make_tile(film.bounds());
    tile.add(0, 0, XYZ{1.0f, 7.0f, 1.0f}, 1.0f);
    film.merge(tile);
    EXPECT_EQ(first_pixel_variance(film).variance.y, 0.0);
    EXPECT_EQ(first_pixel_variance(film).standard_error.y, 0.0);
    film.merge(tile);
    EXPECT_EQ(first_pixel_variance(film).variance.y, 0.0) << "two samples alike";
}

// With sums of squared weights: by the sum of squared deviations, for whatever signs the weights have.
TEST(FilmVariance, IsThatOfARatioUnderLobes) {
    for (const FilmVariance kind : {FilmVariance::luminance, FilmVariance::xyz}) {
        Film film({.width_px = 1, .height_px = 1, .filter = MitchellFilter{}, .variance = kind});
        FilmTile tile = film.make_tile(film.bounds());
        Pcg32 random(5);
        struct Sample {
            XYZd value;
            double weight = 0.0;
        };
        std::vector<Sample> samples;
        XYZd weighted;
        double weight_sum = 0.0, squared_weights = 0.0;
        for (int i = 0; i < 50; ++i) {
            const float weight = i % 7 == 0 ? -0.75f : 1.25f + random.next_float();
            const XYZ value{random.next_float(), 3.0f - weight, 40.0f * random.next_float()};
            tile.add(0, 0, value, weight);
            samples.push_back({{double{value.x}, double{value.y}, double{value.z}}, double{weight}});
            weighted = weighted + double{weight} * samples.back().value;
            weight_sum += double{weight};
            squared_weights += squared(double{weight});
        }
        film.merge(tile);
        const PixelVariance found = first_pixel_variance(film);
        for (double XYZd::*component : {&XYZd::x, &XYZd::y, &XYZd::z}) {
            if (kind == FilmVariance::luminance && component != &XYZd::y) {
                EXPECT_EQ(found.variance.*component, 0.0);
                continue;
            }
            double deviations = 0.0;
            for (const Sample& s : samples) {
                deviations += squared(s.weight * (s.value.*component - weighted.*component / weight_sum));
            }
            const double error = std::sqrt(50.0 / 49.0 * deviations) / weight_sum;
            EXPECT_NEAR(found.standard_error.*component, error, 1e-10 * error);
            EXPECT_NEAR(found.variance.*component, squared(error * weight_sum) / squared_weights,
                        1e-10 * squared(error * weight_sum));
        }
    }
}

// sum(w) = 2.5 and sum(w^2) = 6.25: an effective number of one sample, and still an error. R = 6;
// se^2 = 4/3 * 1.25^2 (5^2 + 3^2 + 2^2 + 4^2) / 2.5^2 = 18.
TEST(FilmVariance, IsNotZeroWhereWeightsCancel) {
    Film film({.width_px = 1, .height_px = 1, .filter = MitchellFilter{}, .variance = FilmVariance::luminance});
    FilmTile tile = film.make_tile(film.bounds());
    for (const auto& [weight, y] : {std::pair{1.25f, 1.0f}, {1.25f, 9.0f}, {1.25f, 4.0f}, {-1.25f, 2.0f}}) {
        tile.add(0, 0, XYZ{y, y, y}, weight);
    }
    film.merge(tile);
    const PixelVariance found = first_pixel_variance(film);
    EXPECT_NEAR(found.standard_error.y, std::sqrt(18.0), 1e-12);
    EXPECT_NEAR(found.variance.y, 18.0, 1e-11);
}

// Sums of squares are exact, too.
TEST(FilmVariance, IsBitIdenticalForEveryOrder) {
    for (const Filter& filter : {Filter(BoxFilter{}), Filter(MitchellFilter{})}) {
        const FilmOptions options{.width_px = 6, .height_px = 5, .filter = filter, .variance = FilmVariance::xyz};
        std::vector<FilmTile> tiles;
        const Film any(options);
        Pcg32 random(8);
        for (int i = 0; i < 20; ++i) {
            tiles.push_back(any.make_tile({i % 3, i % 2, i % 3 + 3, i % 2 + 4}));
            for (int s = 0; s < 200; ++s) {
                const float size = std::ldexp(1.0f, static_cast<int>(random.next() % 40u) - 20);
                tiles.back().add(i % 3 + s % 3, i % 2 + s / 3 % 4, XYZ{size, size * random.next_float(), size},
                                 random.next_float() < 0.1f ? -1.1f : 1.1f);
            }
        }
        Film forwards(options), backwards(options);
        for (std::size_t i = 0; i < tiles.size(); ++i) {
            forwards.merge(tiles[i]);
            backwards.merge(tiles[tiles.size() - 1 - i]);
        }
        EXPECT_TRUE(forwards.contents() == backwards.contents()) << to_text(filter);
    }
}

TEST(FilmVariance, LeavingTheRangeIsSeen) {
    Film film({.width_px = 1, .height_px = 1, .variance = FilmVariance::luminance});
    FilmTile tile = film.make_tile(film.bounds());
    tile.add(0, 0, XYZ{1e11f, 1e11f, 1e11f}, 1.0f);
    film.merge(tile);
    EXPECT_EQ(film.saturated_pixels(), 1);
    EXPECT_TRUE(std::isfinite(first_pixel_variance(film).variance.y));
}

}  // namespace
}  // namespace emulsion
