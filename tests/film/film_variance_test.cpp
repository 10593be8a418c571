// Variances and standard errors of pixels.

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
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

// Independent pixels that see one thing: a step from 0 to 10 at a place below the pixel's centre, or noise of variance
// 1/12 about 3.
struct Sight {
    double edge_px = 0.0;
    bool is_noise = false;
};

float seen(const Sight& sight, double y_offset_px, Pcg32& random) {
    if (sight.is_noise) return 2.5f + random.next_float();
    return y_offset_px < sight.edge_px ? 0.0f : 10.0f;
}

/// A row of pixels; under a splatted filter, one in `stride` is none's neighbour. Places are independent of each other.
struct Row {
    Film film;
    int stride = 1;
};

Row row_of_pixels(const Filter& filter, FilterUse use, int pixels) {
    const bool splatted = use == FilterUse::splatted;
    const int stride = splatted ? static_cast<int>(std::ceil(2.0 * radius_px(filter, FilterAxis::x))) + 1 : 1;
    return {Film({.width_px = pixels * stride,
                  .height_px = 1,
                  .filter = filter,
                  .filter_use = use,
                  .variance = FilmVariance::luminance}),
            stride};
}

void look(Row& row, const Sight& sight, int samples, std::uint64_t seed) {
    const FilmOptions& options = row.film.options();
    const PixelBounds places = row.film.sample_bounds();
    FilmTile tile = row.film.make_tile(places);
    Pcg32 random(seed);
    const auto add_everywhere = [&](auto add) {
        for (int x = places.x0; x < places.x1; ++x) {
            for (int i = 0; i < samples; ++i) add(x);
        }
    };
    const auto grey = [](float value) { return XYZ{value, value, value}; };
    if (options.filter_use == FilterUse::importance_sampled) {
        const FilterSampler sampler(options.filter);
        add_everywhere([&](int x) {
            const float u = random.next_float(), v = random.next_float();
            const FilterSample place = sampler.sample(u, v);
            tile.add(x, 0, grey(seen(sight, static_cast<double>(place.y_offset_px), random)), place.weight);
        });
    } else {
        const auto width = static_cast<float>(places.width()), height = static_cast<float>(places.height());
        add_everywhere([&](int) {
            const float x = static_cast<float>(places.x0) + width * random.next_float();
            const float y = static_cast<float>(places.y0) + height * random.next_float();
            tile.add_at(x, y, grey(seen(sight, static_cast<double>(y) - 0.5, random)));
        });
    }
    row.film.merge(tile);
}

// Under filters with lobes as well, and at edges, where their samples have as much to say as any: the mean square of
// the standard errors is the variance of the pixels. That one has a relative standard error of sqrt(2 / 1000) = 0.045
// over 1,000 pixels that are as good as normal. Eight filters, two uses and five sights make 80 comparisons, so
// that 4.6 of those are a confidence of 99.97 % in all of them. On top comes the estimate's own bias, of the order of
// 1/n: with n from 200 / 3.4 = 59 on, what differed was 0.17 at most at half of that, and 0.07 at double.
TEST(FilmVariance, StandardErrorIsTheErrorOfPixelsAtEdgesUnderLobes) {
    constexpr int kPixels = 1000;
    int filters = 0;
    for (const Filter& filter : testing::example_filters()) {
        if (!has_negative_lobes(filter)) continue;
        ++filters;
        for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
            for (const Sight& sight : {Sight{.edge_px = 0.0}, Sight{.edge_px = 0.4}, Sight{.edge_px = -1.25},
                                       Sight{.edge_px = 1.25}, Sight{.is_noise = true}}) {
                Row row = row_of_pixels(filter, use, kPixels);
                look(row, sight, 200, 7);
                double sum = 0.0, squares = 0.0, claim = 0.0;
                row.film.for_each_pixel([&](std::size_t i, const PixelSums& sums) {
                    if (i % static_cast<std::size_t>(row.stride) != 0) return;
                    const double value = mean_of(sums)->y;
                    sum += value;
                    squares += squared(value);
                    claim += squared(variance_of(sums, row.film.setup()).standard_error.y) / kPixels;
                });
                const double variance = (squares - squared(sum) / kPixels) / (kPixels - 1);
                EXPECT_NEAR(claim / variance, 1.0, 4.6 * 0.0447 + 0.08)
                    << to_text(filter) << (use == FilterUse::splatted ? " splatted" : " drawn") << ", edge at "
                    << sight.edge_px << (sight.is_noise ? ", noise" : "");
            }
        }
    }
    EXPECT_EQ(filters, 8);
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

// Sums of squares are exact, too.
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
