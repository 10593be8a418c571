// Light splats: over the number of paths, beside camera samples, from beyond the edge.

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "film/film.h"
#include "film_splat_fixture.h"
#include "filter_examples.h"

namespace emulsion {
namespace {

using testing::example_filters;
using testing::filtered_scene;
using testing::name_of;
using testing::scene;

// Paths of light that arrive anywhere in the frame and beyond, each with the picture's value times the area: the mean
// over paths is the picture. 2^18 paths on a Sobol'-like grid leave 1 %.
TEST(FilmLightSplat, IsOverTheNumberOfPaths) {
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
TEST(FilmLightSplat, SamplesAndLightAddUp) {
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

TEST(FilmLightSplat, FromBeyondReachesInAndTheRestIsIgnored) {
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

TEST(FilmLightSplat, PathsStayAtTheEndOfTheirRange) {
    constexpr auto kMost = std::numeric_limits<std::uint64_t>::max();
    Film film({.width_px = 1, .height_px = 1, .light_splats = true});
    film.add_light_paths(5);
    film.add_light_paths(kMost - 1);
    EXPECT_EQ(film.counts().light_paths, kMost);
    FilmCounts a, b;
    a.add_light_paths(kMost - 3);
    b.add_light_paths(3);
    a.merge(b);
    EXPECT_EQ(a.light_paths, kMost);
    a.merge(b);
    EXPECT_EQ(a.light_paths, kMost);
}

}  // namespace
}  // namespace emulsion
