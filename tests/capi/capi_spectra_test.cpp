// Spectral samples through the C interface, of any number of wavelengths: bit for bit those of C++.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "capi/emulsion.h"
#include "capi_fixture.h"
#include "film/film.h"
#include "film/sensor.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion {
namespace {

using testing::add_in_c;
using testing::add_in_cpp;
using testing::c_film;
using testing::c_tile;
using testing::cpp_options;
using testing::expect_same;
using testing::FilmHandle;
using testing::kHeight_px;
using testing::kTile;
using testing::kWidth_px;
using testing::kXyzNumbers;
using testing::Samples;
using testing::TileHandle;

TEST(CapiSpectra, AreThoseOfCpp) {
    for_each_wavelength_count([]<int N>() {
        SCOPED_TRACE(N);
        const Samples samples(N);
        Film film(cpp_options());
        FilmTile tile = film.make_tile(kTile);
        add_in_cpp<N>(tile, samples);
        film.merge(tile);

        const FilmHandle got = c_film();
        const TileHandle got_tile = c_tile(got);
        ASSERT_EQ(add_in_c(got_tile, samples, N), EMULSION_OK) << emulsion_last_error();
        ASSERT_EQ(emulsion_film_merge_tile(got.get(), got_tile.get()), EMULSION_OK);
        expect_same(got, film);
    });
}

// One sample a pixel of the sum of all, against the sum in double precision. The sensor is within 4e-6 of X + Y + Z,
// and the radiance is scaled by a float, which is another 1e-7.
TEST(CapiSpectra, EveryNumberOfWavelengthsWillDo) {
    for (std::size_t wavelengths = 1; wavelengths <= EMULSION_MAX_WAVELENGTHS; ++wavelengths) {
        const Samples samples(wavelengths);
        const FilmHandle film = c_film();
        const TileHandle tile = c_tile(film);
        const std::int32_t x = kTile.x0, y = kTile.y0;
        ASSERT_EQ(emulsion_tile_add_spectral(tile.get(), 1, &x, &y, nullptr, wavelengths, samples.lambda_nm.data(),
                                             samples.radiance.data(), samples.pdf.data()),
                  EMULSION_OK);
        ASSERT_EQ(emulsion_film_merge_tile(film.get(), tile.get()), EMULSION_OK);
        std::vector<float> pixels(kXyzNumbers);
        ASSERT_EQ(emulsion_film_read_xyz(film.get(), pixels.data(), pixels.size()), EMULSION_OK);

        const Sensor sensor(cpp_options().sensor);
        XYZd sum;
        for (std::size_t k = 0; k < wavelengths; ++k) {
            const double scaled = static_cast<double>(samples.radiance[k]) / static_cast<double>(samples.pdf[k]);
            sum = sum + scaled * sensor.response(static_cast<double>(samples.lambda_nm[k]));
        }
        const double n = static_cast<double>(wavelengths), tolerance = 5e-6 * (sum.x + sum.y + sum.z) / n;
        const float* got = &pixels[std::size_t{3} * (kTile.y0 * kWidth_px + kTile.x0)];
        EXPECT_NEAR(static_cast<double>(got[0]), sum.x / n, tolerance) << wavelengths;
        EXPECT_NEAR(static_cast<double>(got[1]), sum.y / n, tolerance) << wavelengths;
        EXPECT_NEAR(static_cast<double>(got[2]), sum.z / n, tolerance) << wavelengths;
    }
}

/// A wavelength that nobody sees counts as one that carries nothing.
TEST(CapiSpectra, InvisibleWavelengthsCarryNothing) {
    const std::array<float, 4> lambda_nm = {300.0f, 550.0f, 900.0f, 1e30f}, radiance = {9.0f, 2.0f, 9.0f, 9.0f};
    const std::array<float, 4> pdf = {0.01f, 0.01f, 0.01f, 0.01f}, seen = {0.0f, 2.0f, 0.0f, 0.0f};
    const std::array<float, 4> visible = {400.0f, 550.0f, 400.0f, 400.0f};
    const std::int32_t x = kTile.x0, y = kTile.y0;
    std::vector<std::vector<float>> pictures;
    for (const auto& [wavelengths, values] : {std::pair{lambda_nm, radiance}, std::pair{visible, seen}}) {
        const FilmHandle film = c_film();
        const TileHandle tile = c_tile(film);
        for (const std::size_t count : {2u, 3u, 4u}) {
            ASSERT_EQ(emulsion_tile_add_spectral(tile.get(), 1, &x, &y, nullptr, count, wavelengths.data(),
                                                 values.data(), pdf.data()),
                      EMULSION_OK);
        }
        ASSERT_EQ(emulsion_film_merge_tile(film.get(), tile.get()), EMULSION_OK);
        std::vector<float>& xyz = pictures.emplace_back(kXyzNumbers);
        ASSERT_EQ(emulsion_film_read_xyz(film.get(), xyz.data(), xyz.size()), EMULSION_OK);
    }
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_GT(pictures[0][std::size_t{3} * (kTile.y0 * kWidth_px + kTile.x0) + 1], 0.0f);
}

}  // namespace
}  // namespace emulsion
