// Splatted camera samples: the expected picture, and what they do to counts and sums.

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"
#include "film_splat_fixture.h"
#include "filter_examples.h"

namespace emulsion {
namespace {

using testing::example_filters;
using testing::filtered_scene;
using testing::name_of;
using testing::scene;
using testing::splatted;

/// n^2 samples on a regular grid to each pixel of the film's sample bounds.
Image<XYZ> splatted_picture(const FilmOptions& options, int n) {
    Film film(options);
    const PixelBounds places = film.sample_bounds();
    FilmTile tile = film.make_tile(places);
    for (int j = places.y0 * n; j < places.y1 * n; ++j) {
        for (int i = places.x0 * n; i < places.x1 * n; ++i) {
            const float x = (static_cast<float>(i) + 0.5f) / static_cast<float>(n);
            const float y = (static_cast<float>(j) + 0.5f) / static_cast<float>(n);
            const auto value = static_cast<float>(scene(static_cast<double>(x), static_cast<double>(y)));
            tile.add_at(x, y, XYZ{0.5f * value, value, 2.0f * value});
        }
    }
    film.merge(tile);
    return film.xyz_image();
}

/// n^2 samples to each pixel whose numbers lie on a regular grid.
Image<XYZ> importance_sampled_picture(FilmOptions options, int n) {
    options.filter_use = FilterUse::importance_sampled;
    Film film(options);
    const FilterSampler sampler(options.filter);
    FilmTile tile = film.make_tile(film.bounds());
    for (int y = 0; y < options.height_px; ++y) {
        for (int x = 0; x < options.width_px; ++x) {
            for (int i = 0; i < n * n; ++i) {
                const auto at = [n](int k) { return (static_cast<float>(k) + 0.5f) / static_cast<float>(n); };
                const FilterSample place = sampler.sample(at(i % n), at(i / n));
                const auto value = static_cast<float>(scene(x + 0.5 + static_cast<double>(place.x_offset_px),
                                                            y + 0.5 + static_cast<double>(place.y_offset_px)));
                tile.add(x, y, XYZ{0.5f * value, value, 2.0f * value}, place.weight);
            }
        }
    }
    film.merge(tile);
    return film.xyz_image();
}

// Both ways of using a filter, and the integral itself. Regular grids of 24^2 and 192^2 samples a pixel: what is left
// is their own error, of first order in the spacing at the jumps of a box, and of the drawn ones at every change of
// sign.
TEST(FilmSplat, BothUsesOfAFilterExpectTheFilteredPicture) {
    for (const Filter& filter : example_filters()) {
        const FilmOptions options = splatted(3, 3, filter);
        const Image<XYZ> spread = splatted_picture(options, 24), drawn = importance_sampled_picture(options, 192);
        for (int i = 0; i < 9; ++i) {
            const int x = i % 3, y = i / 3;
            const double expected = filtered_scene(filter, x, y);
            EXPECT_NEAR(static_cast<double>(spread(x, y).y), expected, 0.02) << name_of(filter);
            EXPECT_NEAR(static_cast<double>(drawn(x, y).y), expected, 0.02) << name_of(filter);
            EXPECT_NEAR(spread(x, y).x, 0.5f * spread(x, y).y, 1e-6f);
            EXPECT_NEAR(spread(x, y).z, 2.0f * spread(x, y).y, 4e-6f);
        }
    }
}

TEST(FilmSplat, ReconstructsAConstantUnderEveryFilter) {
    for (const Filter& filter : example_filters()) {
        Film film(splatted(4, 4, filter));
        const PixelBounds places = film.sample_bounds();
        FilmTile tile = film.make_tile(places);
        Pcg32 random(2);
        for (int i = 0; i < 256 * places.width() * places.height(); ++i) {
            const float x = static_cast<float>(places.x0) + static_cast<float>(places.width()) * random.next_float();
            const float y = static_cast<float>(places.y0) + static_cast<float>(places.height()) * random.next_float();
            tile.add_at(x, y, XYZ{0.3f, 40.0f, 5e6f});
        }
        film.merge(tile);
        EXPECT_EQ(film.pixels_without_value(), 0) << name_of(filter);
        const Image<XYZ> image = film.xyz_image();
        for (const XYZ& pixel : image.pixels()) {
            EXPECT_NEAR(pixel.x, 0.3f, 0.3e-6f);
            EXPECT_NEAR(pixel.y, 40.0f, 40e-6f);
            EXPECT_NEAR(pixel.z, 5e6f, 5.0f);
        }
    }
}

// A pixel makes room in its sums when its count comes to certain numbers, which a splat in between may step over: sums
// still stop at their end, and do not come round. 2^27 samples of nearly 2^27 cd/m^2.
TEST(FilmSplat, MixedWithPlainSamplesSumsStillDoNotWrap) {
    Film film(splatted(1, 1, BoxFilter{}));
    FilmTile tile = film.make_tile(film.bounds());
    const XYZ bright{0x1.fp26f, 0x1.fp26f, 0x1.fp26f};
    for (int i = 0; i < (1 << 21); ++i) {
        for (int k = 0; k < 63; ++k) tile.add(0, 0, bright, 1.0f);
        tile.add_at(0.5f, 0.5f, bright);
    }
    film.merge(tile);
    EXPECT_EQ(film.saturated_pixels(), 1);
    EXPECT_GT(film.xyz_image()(0, 0).y, 1e6f);
}

TEST(FilmSplat, CountsEachSampleOnce) {
    Film film(splatted(8, 8, MitchellFilter{}));
    FilmTile tile = film.make_tile({0, 0, 8, 8});
    for (int i = 0; i < 10; ++i) tile.add_at(4.3f, 4.6f, XYZ{1.0f, 1.0f, 1.0f});
    tile.add_at(4.3f, 4.6f, XYZ{1.0f, -1.0f, 1.0f});
    film.merge(tile);
    EXPECT_EQ(film.sample_count(), 10u);
    EXPECT_EQ(film.dropped().count(), 1u);
    EXPECT_EQ(film.max_samples_per_pixel(), 10u);
    EXPECT_EQ(film.min_samples_per_pixel(), 0u);
    tile.clear();
    EXPECT_EQ(tile.sample_count(), 0u);
}

}  // namespace
}  // namespace emulsion
