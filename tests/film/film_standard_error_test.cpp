// What the standard error of pixels claims, beside what pixels do.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"
#include "filter_examples.h"

namespace emulsion {
namespace {

double squared(double value) { return value * value; }

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
TEST(FilmStandardError, IsTheErrorOfPixels) {
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
TEST(FilmStandardError, IsTheErrorOfPixelsAtEdgesUnderLobes) {
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

}  // namespace
}  // namespace emulsion
