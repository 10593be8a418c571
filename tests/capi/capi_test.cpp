// The C interface gives, bit for bit, what the C++ interface gives: samples as XYZ, as RGB, with places; by threads.

#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "capi/emulsion.h"
#include "capi_fixture.h"
#include "film/film.h"
#include "film/rgb_input.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

using testing::add_in_c;
using testing::add_in_cpp;
using testing::c_film;
using testing::c_options;
using testing::c_tile;
using testing::cpp_options;
using testing::expect_ok;
using testing::expect_same;
using testing::FilmHandle;
using testing::kCount;
using testing::kTile;
using testing::Samples;
using testing::TileHandle;

TEST(Capi, XyzSamplesAreThoseOfCpp) {
    const Samples samples(1);
    Film film(cpp_options());
    FilmTile tile = film.make_tile(kTile);
    for (std::size_t i = 0; i < kCount; ++i) {
        tile.add(samples.x[i], samples.y[i], samples.triple(i), samples.weight[i]);
    }
    film.merge(tile);

    const FilmHandle got = c_film();
    const TileHandle got_tile = c_tile(got);
    ASSERT_EQ(emulsion_tile_add_xyz(got_tile.get(), kCount, samples.x.data(), samples.y.data(), samples.weight.data(),
                                    samples.triples.data()),
              EMULSION_OK);
    ASSERT_EQ(emulsion_film_merge_tile(got.get(), got_tile.get()), EMULSION_OK);
    expect_same(got, film);
}

TEST(Capi, RgbSamplesAreXyzTimesTheImagingRatio) {
    const Samples samples(1);
    Film film(cpp_options());
    FilmTile tile = film.make_tile(kTile);
    const RgbInput input(rgb_space("Rec2020"), 0.5);
    for (std::size_t i = 0; i < kCount; ++i) {
        const XYZ rgb = samples.triple(i);
        tile.add(samples.x[i], samples.y[i], input.to_xyz({rgb.x, rgb.y, rgb.z}), 1.0f);
    }
    film.merge(tile);

    const FilmHandle got = c_film();
    const TileHandle got_tile = c_tile(got);
    ASSERT_EQ(emulsion_tile_add_rgb(got_tile.get(), kCount, samples.x.data(), samples.y.data(), nullptr, "rec2020",
                                    samples.triples.data()),
              EMULSION_OK);
    ASSERT_EQ(emulsion_film_merge_tile(got.get(), got_tile.get()), EMULSION_OK);
    expect_same(got, film);
}

TEST(Capi, PlacesAndLightSplatsAreThoseOfCpp) {
    FilmOptions options = cpp_options();
    options.crop = PixelBounds{1, 2, 8, 6};
    options.filter = MitchellFilter{};
    options.filter_use = FilterUse::splatted;
    options.light_splats = true;
    Film film(options);
    const PixelBounds places = film.sample_bounds();
    FilmTile tile = film.make_tile(places);
    const Samples samples(4);
    const RgbInput input(rgb_space("Rec2020"), 0.5);
    for (std::size_t i = 0; i < kCount; ++i) {
        const float x = samples.x_px[i], y = samples.y_px[i];
        const XYZ triple = samples.triple(i);
        tile.add_at(x, y, samples.wavelengths_of<4>(i), samples.radiance_of<4>(i));
        tile.add_at(x, y, triple);
        tile.add_at(x, y, input.to_xyz({triple.x, triple.y, triple.z}));
        tile.splat(x, y, samples.wavelengths_of<4>(i), samples.radiance_of<4>(i));
        tile.splat(x, y, triple);
    }
    film.merge(tile);
    film.add_light_paths(700);

    emulsion_film_options same = c_options();
    same.crop = {1, 2, 8, 6};
    same.filter = "mitchell";
    same.filter_use = EMULSION_SPLATTED;
    same.light_splats = 1;
    const FilmHandle got = c_film(same);
    const TileHandle got_tile = c_tile(got, places);
    const float *const x = samples.x_px.data(), *const y = samples.y_px.data(), *const triples = samples.triples.data();
    const float *const lambda_nm = samples.lambda_nm.data(), *const radiance = samples.radiance.data(),
                       *const pdf = samples.pdf.data();
    expect_ok(emulsion_tile_add_at_spectral(got_tile.get(), kCount, x, y, 4, lambda_nm, radiance, pdf));
    expect_ok(emulsion_tile_add_at_xyz(got_tile.get(), kCount, x, y, triples));
    expect_ok(emulsion_tile_add_at_rgb(got_tile.get(), kCount, x, y, "Rec2020", triples));
    expect_ok(emulsion_tile_splat_spectral(got_tile.get(), kCount, x, y, 4, lambda_nm, radiance, pdf));
    expect_ok(emulsion_tile_splat_xyz(got_tile.get(), kCount, x, y, triples));
    expect_ok(emulsion_film_merge_tile(got.get(), got_tile.get()));
    expect_ok(emulsion_film_add_light_paths(got.get(), 700));
    expect_same(got, film);
    EXPECT_GT(film.xyz_image()(3, 2).y, 0.0f);
}

TEST(Capi, ThreadsHaveTilesOfTheirOwn) {
    constexpr std::size_t kThreads = 8;
    Film film(cpp_options());
    const FilmHandle got = c_film();
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < kThreads; ++t) {
        threads.emplace_back([&got, t] {
            const TileHandle tile = c_tile(got);
            const Samples samples(4, t);
            for (int pass = 0; pass < 10; ++pass) EXPECT_EQ(add_in_c(tile, samples, 4), EMULSION_OK);
            EXPECT_EQ(emulsion_tile_add_xyz(nullptr, 1, nullptr, nullptr, nullptr, nullptr), EMULSION_INVALID_ARGUMENT);
            EXPECT_EQ(emulsion_film_merge_tile(got.get(), tile.get()), EMULSION_OK);
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (std::size_t t = 0; t < kThreads; ++t) {
        FilmTile tile = film.make_tile(kTile);
        for (int pass = 0; pass < 10; ++pass) add_in_cpp<4>(tile, Samples(4, t));
        film.merge(tile);
    }
    expect_same(got, film);
}

}  // namespace
}  // namespace emulsion
