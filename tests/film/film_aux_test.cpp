// Auxiliary layers: albedo, normal, depth and others by name.

#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "film/film.h"

namespace emulsion {
namespace {

FilmOptions with_layers(FilterUse use = FilterUse::importance_sampled) {
    return {.width_px = 4,
            .height_px = 4,
            .filter = TriangleFilter{},
            .filter_use = use,
            .aux = {known_aux_layer("normal"), {"my-id_2", {"value"}}}};
}

double value_at(const Film& film, std::size_t pixel, std::size_t layer, std::size_t component) {
    double value = 0.0;
    film.for_each_pixel([&](std::size_t i, const PixelSums& sums) {
        if (i == pixel) value = aux_value_of(sums, film.setup(), layer, component);
    });
    return value;
}

TEST(FilmAux, IsTheWeightedMeanOfSamplesThatSeeSomething) {
    Film film(with_layers());
    FilmTile tile = film.make_tile(film.bounds());
    for (int i = 0; i < 4; ++i) tile.add(1, 0, XYZ{1.0f, 1.0f, 1.0f}, 1.0f);
    tile.add_aux(1, 0, 0, std::array{0.0f, 1.0f, 0.5f}, 1.0f);
    tile.add_aux(1, 0, 0, std::array{1.0f, 0.0f, 0.5f}, 3.0f);
    tile.add_aux(1, 0, 1, std::array{-7.0f}, 0.5f);
    film.merge(tile);
    EXPECT_DOUBLE_EQ(value_at(film, 1, 0, 0), 0.75);
    EXPECT_DOUBLE_EQ(value_at(film, 1, 0, 1), 0.25);
    EXPECT_DOUBLE_EQ(value_at(film, 1, 0, 2), 0.5);
    EXPECT_DOUBLE_EQ(value_at(film, 1, 1, 0), -7.0) << "negative values are as good as others";
    EXPECT_EQ(value_at(film, 2, 1, 0), 0.0) << "nothing was seen";
    EXPECT_EQ(film.xyz_image()(1, 0), (XYZ{1.0f, 1.0f, 1.0f}));
}

// As with XYZ: weights that cancel to less than 1/64 in the mean leave no value, however many samples there are.
TEST(FilmAux, CancellingWeightsGiveNoValue) {
    Film film(with_layers());
    FilmTile tile = film.make_tile(film.bounds());
    for (int i = 0; i < 100; ++i) {
        for (const auto& [value, weight] : {std::pair(7.0f, 1.0f), std::pair(1.0f, -0.99f)}) {
            tile.add(0, 0, XYZ{1.0f, 1.0f, 1.0f}, weight);
            tile.add_aux(0, 0, 1, std::array{value}, weight);
        }
    }
    film.merge(tile);
    EXPECT_EQ(value_at(film, 0, 1, 0), 0.0);
    EXPECT_EQ(film.pixels_without_value(), 16);
}

TEST(FilmAux, ValuesThatAreNotFiniteAreCounted) {
    Film film(with_layers());
    FilmTile tile = film.make_tile(film.bounds());
    tile.add_aux(0, 0, 0, std::array{0.0f, std::nanf(""), 1.0f}, 1.0f);
    tile.add_aux(0, 0, 1, std::array{HUGE_VALF}, 1.0f);
    tile.add_aux(0, 0, 1, std::array{1.0f}, std::nanf(""));
    tile.add_aux(0, 0, 1, std::array{5.0f}, 1.0f);
    film.merge(tile);
    EXPECT_EQ(film.counts().dropped_aux, 3u);
    EXPECT_EQ(value_at(film, 0, 0, 2), 0.0);
    EXPECT_EQ(value_at(film, 0, 1, 0), 5.0);
    EXPECT_EQ(film.dropped().count(), 0u);
}

TEST(FilmAux, SplattedValuesAreFilteredAsSamplesAre) {
    Film film(with_layers(FilterUse::splatted));
    FilmTile tile = film.make_tile(film.bounds());
    for (const auto& [x, value] : {std::pair(0.5f, 8.0f), std::pair(2.0f, 2.0f)}) {
        tile.add_at(x, 0.5f, XYZ{value, value, value});
        tile.add_aux_at(x, 0.5f, 1, std::array{value});
    }
    tile.add_aux_at(1.0f, 1.0f, 1, std::array{std::nanf("")});
    film.merge(tile);
    const Image<XYZ> image = film.xyz_image();
    for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_NEAR(value_at(film, i, 1, 0), static_cast<double>(image.pixels()[i].y), 1e-6);
    }
    EXPECT_EQ(film.counts().dropped_aux, 1u);
}

}  // namespace
}  // namespace emulsion
