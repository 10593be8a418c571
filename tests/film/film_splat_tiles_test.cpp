// Splatted camera samples and light splats: no tile and no crop window changes a bit.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "film_splat_fixture.h"
#include "filter_examples.h"

namespace emulsion {
namespace {

using testing::example_filters;
using testing::name_of;
using testing::splatted;

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

TEST(FilmSplatTiles, IsBitIdenticalForEverySizeOfTiles) {
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
TEST(FilmSplatTiles, CropIsTheCutOfTheFullFrame) {
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

}  // namespace
}  // namespace emulsion
