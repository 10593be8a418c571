// Variances and standard errors of pixels.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"
#include "filter_examples.h"

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

/// Independent noise of variance 1/12 about 3, n samples to a pixel, seen through a filter.
Film& noisy_film(Film& film, int samples, std::uint64_t seed) {
    Pcg32 random(seed);
    const FilmOptions& options = film.options();
    const PixelBounds places = film.sample_bounds();
    FilmTile tile = film.make_tile(places);
    const FilterSampler sampler(options.filter);
    const auto noise = [&] {
        const float value = 2.5f + random.next_float();
        return XYZ{value, value, value};
    };
    for (int y = places.y0; y < places.y1; ++y) {
        for (int x = places.x0; x < places.x1; ++x) {
            for (int i = 0; i < samples; ++i) {
                const float u = random.next_float(), v = random.next_float();
                if (options.filter_use == FilterUse::splatted) {
                    tile.add_at(static_cast<float>(x) + u, static_cast<float>(y) + v, noise());
                } else {
                    tile.add(x, y, noise(), sampler.sample(u, v).weight);
                }
            }
        }
    }
    film.merge(tile);
    return film;
}

// What the standard error says is what pixels do: over 1,600 pixels of one colour, the mean square of (pixel - 3) over
// the mean square of the standard error is 1, for every filter and both of its uses, to 1/n (256 / 3.4 = 75 at the
// worst). Neighbours that share samples are correlated, so that a pixel in 16 counts: the ratio's own standard error is
// sqrt(2 / (1600 / 16)) = 0.14 at the worst.
TEST(FilmVariance, StandardErrorIsTheErrorOfPixels) {
    for (const Filter& filter : testing::example_filters()) {
        for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
            Film film({.width_px = 40,
                       .height_px = 40,
                       .filter = filter,
                       .filter_use = use,
                       .variance = FilmVariance::luminance});
            noisy_film(film, 256, 11);
            double squared_error = 0.0, squared_claim = 0.0, variance = 0.0;
            film.for_each_pixel([&](std::size_t, const PixelSums& sums) {
                const PixelVariance claim = variance_of(sums, film.setup());
                squared_error += squared(mean_of(sums)->y - 3.0);
                squared_claim += squared(claim.standard_error.y);
                variance += claim.variance.y / 1600.0;
            });
            EXPECT_NEAR(squared_error / squared_claim, 1.0, use == FilterUse::splatted ? 0.42 : 0.15)
                << to_text(filter) << (use == FilterUse::splatted ? " splatted" : " drawn");
            EXPECT_NEAR(variance, 1.0 / 12.0, 0.02 / 12.0) << to_text(filter);
        }
    }
}

// Sums of squares are exact, too.
TEST(FilmVariance, IsBitIdenticalForEveryOrder) {
    const FilmOptions options{.width_px = 6, .height_px = 5, .variance = FilmVariance::xyz};
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
    EXPECT_TRUE(forwards.contents() == backwards.contents());
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
