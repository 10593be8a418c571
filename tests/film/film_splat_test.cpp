// Splatted camera samples and light splats: the expected picture, and that of crop windows.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "film/filter_sampler.h"
#include "filter_examples.h"

namespace emulsion {
namespace {

using testing::example_filters;
using testing::name_of;

/// What is to be seen at a place: smooth, and of a different size in each direction.
double scene(double x_px, double y_px) { return 1.0 + std::sin(0.9 * x_px) * std::cos(0.6 * y_px); }

FilmOptions splatted(int width_px, int height_px, const Filter& filter) {
    return {.width_px = width_px, .height_px = height_px, .filter = filter, .filter_use = FilterUse::splatted};
}

/// The integral of the scene with the filter about a pixel's centre, over that of the filter; by midpoints.
double filtered_scene(const Filter& filter, int x, int y) {
    constexpr int kSteps = 256;
    const double x_radius = radius_px(filter, FilterAxis::x), y_radius = radius_px(filter, FilterAxis::y);
    double sum = 0.0, weights = 0.0;
    for (int j = 0; j < kSteps; ++j) {
        const double y_offset = y_radius * (2.0 * (j + 0.5) / kSteps - 1.0);
        const double y_weight = eval(filter, FilterAxis::y, y_offset);
        for (int i = 0; i < kSteps; ++i) {
            const double x_offset = x_radius * (2.0 * (i + 0.5) / kSteps - 1.0);
            const double weight = y_weight * eval(filter, FilterAxis::x, x_offset);
            sum += weight * scene(x + 0.5 + x_offset, y + 0.5 + y_offset);
            weights += weight;
        }
    }
    return sum / weights;
}

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

struct Place {
    float x_px = 0.0f, y_px = 0.0f;
    XYZ value;
};

/// Anywhere in the bounds, of very different sizes, some of them bad.
std::vector<Place> wild_places(const PixelBounds& bounds, int count) {
    std::vector<Place> places;
    Pcg32 random(9);
    for (int i = 0; i < count; ++i) {
        const float x = static_cast<float>(bounds.x0) + static_cast<float>(bounds.width()) * random.next_float();
        const float y = static_cast<float>(bounds.y0) + static_cast<float>(bounds.height()) * random.next_float();
        const float size = std::ldexp(1.0f, static_cast<int>(random.next() % 40u) - 20);
        const bool is_bad = random.next() % 499u == 0;
        places.push_back({x, y, XYZ{size * random.next_float(), is_bad ? -size : size, size * random.next_float()}});
    }
    return places;
}

FilmOptions with_everything(const Filter& filter) {
    FilmOptions options = splatted(40, 30, filter);
    options.light_splats = true;
    options.variance = FilmVariance::xyz;
    return options;
}

/// Camera samples and light splats, each to the tile of `tile_px` pixels that has its place.
void add_by_tiles(Film& film, const std::vector<Place>& places, int tile_px) {
    const PixelBounds all = film.sample_bounds();
    const int columns = (all.width() + tile_px - 1) / tile_px;
    std::vector<FilmTile> tiles;
    for (int y = all.y0; y < all.y1; y += tile_px) {
        for (int x = all.x0; x < all.x1; x += tile_px) {
            tiles.push_back(film.make_tile({x, y, std::min(x + tile_px, all.x1), std::min(y + tile_px, all.y1)}));
        }
    }
    for (const Place& place : places) {
        const int column = (static_cast<int>(std::floor(place.x_px)) - all.x0) / tile_px;
        const int row = (static_cast<int>(std::floor(place.y_px)) - all.y0) / tile_px;
        const bool is_inside = place.x_px >= static_cast<float>(all.x0) && place.x_px < static_cast<float>(all.x1) &&
                               place.y_px >= static_cast<float>(all.y0) && place.y_px < static_cast<float>(all.y1);
        if (!is_inside) continue;
        FilmTile& tile = tiles[static_cast<std::size_t>(row * columns + column)];
        tile.add_at(place.x_px, place.y_px, place.value);
        tile.splat(place.x_px, place.y_px, place.value);
    }
    for (const FilmTile& tile : tiles) film.merge(tile);
    film.add_light_paths(1000);
}

TEST(FilmSplat, IsBitIdenticalForEverySizeOfTiles) {
    for (const Filter& filter : {Filter(MitchellFilter{}), Filter(GaussianFilter{3.5f, 1.2f, 1.0f})}) {
        Film expected(with_everything(filter));
        const std::vector<Place> places = wild_places(expected.sample_bounds(), 3000);
        add_by_tiles(expected, places, 64);
        EXPECT_GT(expected.dropped().count(), 0u);
        EXPECT_GT(expected.counts().light_splats, 2900u);
        for (const int tile_px : {1, 3, 8, 16}) {
            Film film(with_everything(filter));
            add_by_tiles(film, places, tile_px);
            EXPECT_TRUE(film.contents() == expected.contents()) << tile_px << " px";
        }
    }
}

// A film with a crop window is the cut of the full frame, to the bit: its samples and its splats, those from beyond the
// window's edge among them.
TEST(FilmSplat, CropIsTheCutOfTheFullFrame) {
    for (const Filter& filter : example_filters()) {
        Film whole(with_everything(filter));
        const std::vector<Place> places = wild_places(whole.sample_bounds(), 5000);
        add_by_tiles(whole, places, 16);
        FilmOptions cropped = with_everything(filter);
        cropped.crop = PixelBounds{7, 11, 23, 18};
        Film cut(cropped);
        add_by_tiles(cut, places, 16);

        const Image<XYZ> full = whole.xyz_image(), part = cut.xyz_image();
        ASSERT_EQ(part.width(), 16);
        ASSERT_EQ(part.height(), 7);
        for (int y = 0; y < 7; ++y) {
            for (int x = 0; x < 16; ++x) EXPECT_EQ(part(x, y), full(x + 7, y + 11)) << name_of(filter);
        }
    }
}

// Paths of light that arrive anywhere in the frame and beyond, each with the picture's value times the area: the mean
// over paths is the picture. 2^18 paths on a Sobol'-like grid leave 1 %.
TEST(FilmSplat, LightSplatsAreOverTheNumberOfPaths) {
    for (const Filter& filter : example_filters()) {
        FilmOptions options{.width_px = 4, .height_px = 3, .filter = filter, .light_splats = true};
        Film film(options);
        const PixelBounds places = film.sample_bounds();
        FilmTile tile = film.make_tile(places);
        constexpr int kSide = 512;
        const auto width = static_cast<float>(places.width()), height = static_cast<float>(places.height());
        for (int i = 0; i < kSide * kSide; ++i) {
            const int column = i % kSide, row = i / kSide;
            const float x = static_cast<float>(places.x0) + width * (static_cast<float>(column) + 0.5f) / kSide;
            const float y = static_cast<float>(places.y0) + height * (static_cast<float>(row) + 0.5f) / kSide;
            const auto value = static_cast<float>(scene(static_cast<double>(x), static_cast<double>(y)));
            tile.splat(x, y, XYZ{0.0f, value * width * height, 0.0f});
        }
        film.merge(tile);
        EXPECT_THROW(static_cast<void>(film.xyz_image()), std::logic_error);
        // Twice as many paths as arrived: half of them sent nothing.
        film.add_light_paths(2 * kSide * kSide);
        EXPECT_EQ(film.pixels_without_value(), 0);
        const Image<XYZ> image = film.xyz_image();
        for (int i = 0; i < 12; ++i) {
            const int x = i % 4, y = i / 4;
            EXPECT_NEAR(2.0 * static_cast<double>(image(x, y).y), filtered_scene(filter, x, y), 0.03)
                << name_of(filter);
        }
    }
}

// Camera samples by weight, light by paths: their sum, whatever the number of samples.
TEST(FilmSplat, SamplesAndLightAddUp) {
    for (const int samples : {1, 7}) {
        Film film({.width_px = 2, .height_px = 1, .light_splats = true});
        FilmTile tile = film.make_tile(film.bounds());
        for (int i = 0; i < samples; ++i) tile.add(0, 0, XYZ{1.0f, 2.0f, 3.0f}, 1.0f);
        tile.splat(0.5f, 0.5f, XYZ{10.0f, 20.0f, 40.0f});
        tile.splat(1.25f, 0.5f, XYZ{1.0f, 1.0f, 1.0f});
        film.merge(tile);
        film.add_light_paths(10);
        const Image<XYZ> image = film.xyz_image();
        EXPECT_EQ(image(0, 0), (XYZ{2.0f, 4.0f, 7.0f}));
        EXPECT_EQ(image(1, 0), (XYZ{0.1f, 0.1f, 0.1f}));
        EXPECT_EQ(film.pixels_without_value(), 1) << "the other has no camera samples";
    }
}

TEST(FilmSplat, LightFromBeyondReachesInAndTheRestIsIgnored) {
    Film film({.width_px = 2, .height_px = 2, .filter = TriangleFilter{}, .light_splats = true});
    EXPECT_EQ(film.sample_bounds(), (PixelBounds{-2, -2, 4, 4}));
    FilmTile tile = film.make_tile(film.sample_bounds());
    tile.splat(-0.5f, 1.0f, XYZ{1.0f, 1.0f, 1.0f});
    for (const float far : {-3.0f, 5.0f, 1e30f, std::nanf("")}) tile.splat(far, 1.0f, XYZ{1.0f, 1.0f, 1.0f});
    tile.splat(0.5f, 0.5f, XYZ{1.0f, std::nanf(""), 1.0f});
    film.merge(tile);
    film.add_light_paths(1);
    EXPECT_EQ(film.counts().light_splats, 1u);
    EXPECT_EQ(film.dropped().count(DroppedKind::nan), 1u);
    // (1 - 1/2) / 2 across and (1 - 0.5/2) / 2 down: triangles of radius 2, integral 2.
    EXPECT_FLOAT_EQ(film.xyz_image()(0, 0).y, 0.25f * 0.375f);
    EXPECT_FLOAT_EQ(film.xyz_image()(1, 0).y, 0.0f);
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
