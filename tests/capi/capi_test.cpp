// The C interface gives, bit for bit, what the C++ interface gives; and turns every exception into a code.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capi/emulsion.h"
#include "capi/status.h"
#include "core/error.h"
#include "core/random.h"
#include "film/exr_file.h"
#include "film/film.h"
#include "film/rgb_input.h"
#include "spectrum/rgb_space.h"
#include "spectrum/sampled_spectrum.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

constexpr int kWidth_px = 9, kHeight_px = 7;
constexpr PixelBounds kTile{2, 1, 8, 7};
constexpr std::size_t kCount = 500;

using FilmHandle = std::unique_ptr<emulsion_film, decltype(&emulsion_film_destroy)>;
using TileHandle = std::unique_ptr<emulsion_tile, decltype(&emulsion_tile_destroy)>;

FilmOptions cpp_options() {
    FilmOptions options;
    options.width_px = kWidth_px;
    options.height_px = kHeight_px;
    options.sensor.exposure_time_s = 0.125;
    options.sensor.iso = 400.0;
    return options;
}

FilmHandle c_film() {
    emulsion_film_options options;
    EXPECT_EQ(emulsion_film_options_init(&options, sizeof options), EMULSION_OK);
    options.width_px = kWidth_px;
    options.height_px = kHeight_px;
    options.exposure_time_s = 0.125;
    options.iso = 400.0;
    emulsion_film* film = nullptr;
    EXPECT_EQ(emulsion_film_create(&options, &film), EMULSION_OK) << emulsion_last_error();
    return {film, emulsion_film_destroy};
}

TileHandle c_tile(const FilmHandle& film) {
    emulsion_tile* tile = nullptr;
    EXPECT_EQ(emulsion_tile_create(film.get(), {kTile.x0, kTile.y0, kTile.x1, kTile.y1}, &tile), EMULSION_OK);
    return {tile, emulsion_tile_destroy};
}

/// Random samples for pixels of the tile.
struct Samples {
    std::vector<std::int32_t> x, y;
    std::vector<float> weight, lambda_nm, radiance, pdf, triples;

    explicit Samples(std::size_t wavelengths, std::uint64_t seed = 1) {
        Pcg32 random(seed);
        for (std::size_t i = 0; i < kCount; ++i) {
            x.push_back(kTile.x0 + static_cast<int>(random.next_float() * static_cast<float>(kTile.width())));
            y.push_back(kTile.y0 + static_cast<int>(random.next_float() * static_cast<float>(kTile.height())));
            weight.push_back(random.next_float() < 0.1f ? -0.5f : 1.1f);
            for (std::size_t k = 0; k < wavelengths; ++k) {
                lambda_nm.push_back(360.0f + 470.0f * random.next_float());
                radiance.push_back(random.next_float());
                pdf.push_back(0.001f + 0.01f * random.next_float());
            }
            for (int k = 0; k < 3; ++k) triples.push_back(random.next_float());
        }
    }
};

/// The pixels, and all counts.
void expect_same(const FilmHandle& got, const Film& expected) {
    std::vector<float> xyz(std::size_t{3} * kWidth_px * kHeight_px);
    ASSERT_EQ(emulsion_film_read_xyz(got.get(), xyz.data(), xyz.size()), EMULSION_OK) << emulsion_last_error();
    const Image<XYZ> image = expected.xyz_image();
    std::size_t i = 0;
    for (const XYZ& pixel : image.pixels()) {
        ASSERT_EQ(pixel, (XYZ{xyz[i], xyz[i + 1], xyz[i + 2]})) << "pixel " << i / 3;
        i += 3;
    }
    std::uint64_t count = 0;
    EXPECT_EQ(emulsion_film_sample_count(got.get(), &count), EMULSION_OK);
    EXPECT_EQ(count, expected.sample_count());
    EXPECT_EQ(emulsion_film_pixels_without_value(got.get(), &count), EMULSION_OK);
    EXPECT_EQ(count, static_cast<std::uint64_t>(expected.pixels_without_value()));
}

template <int N>
void add_in_cpp(FilmTile& tile, const Samples& samples) {
    for (std::size_t i = 0; i < kCount; ++i) {
        SampledWavelengths<N> wavelengths;
        SampledSpectrum<N> radiance;
        for (std::size_t k = 0; k < N; ++k) {
            wavelengths.lambda_nm[k] = samples.lambda_nm[N * i + k];
            wavelengths.pdf[k] = samples.pdf[N * i + k];
            radiance.value[k] = samples.radiance[N * i + k];
        }
        tile.add(samples.x[i], samples.y[i], wavelengths, radiance, samples.weight[i]);
    }
}

emulsion_status add_in_c(const TileHandle& tile, const Samples& samples, std::size_t wavelengths) {
    return emulsion_tile_add_spectral(tile.get(), kCount, samples.x.data(), samples.y.data(), samples.weight.data(),
                                      wavelengths, samples.lambda_nm.data(), samples.radiance.data(),
                                      samples.pdf.data());
}

TEST(Capi, SpectralSamplesAreThoseOfCpp) {
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
TEST(Capi, EveryNumberOfWavelengthsWillDo) {
    for (std::size_t wavelengths = 1; wavelengths <= EMULSION_MAX_WAVELENGTHS; ++wavelengths) {
        const Samples samples(wavelengths);
        const FilmHandle film = c_film();
        const TileHandle tile = c_tile(film);
        const std::int32_t x = kTile.x0, y = kTile.y0;
        ASSERT_EQ(emulsion_tile_add_spectral(tile.get(), 1, &x, &y, nullptr, wavelengths, samples.lambda_nm.data(),
                                             samples.radiance.data(), samples.pdf.data()),
                  EMULSION_OK);
        ASSERT_EQ(emulsion_film_merge_tile(film.get(), tile.get()), EMULSION_OK);
        std::vector<float> pixels(std::size_t{3} * kWidth_px * kHeight_px);
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

TEST(Capi, XyzSamplesAreThoseOfCpp) {
    const Samples samples(1);
    Film film(cpp_options());
    FilmTile tile = film.make_tile(kTile);
    for (std::size_t i = 0; i < kCount; ++i) {
        const float* xyz = &samples.triples[3 * i];
        tile.add(samples.x[i], samples.y[i], XYZ{xyz[0], xyz[1], xyz[2]}, samples.weight[i]);
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
        const float* rgb = &samples.triples[3 * i];
        tile.add(samples.x[i], samples.y[i], input.to_xyz({rgb[0], rgb[1], rgb[2]}), 1.0f);
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

    emulsion_film_options c_options;
    ASSERT_EQ(emulsion_film_options_init(&c_options, sizeof c_options), EMULSION_OK);
    c_options.width_px = kWidth_px;
    c_options.height_px = kHeight_px;
    c_options.exposure_time_s = 0.125;
    c_options.iso = 400.0;
    c_options.crop = {1, 2, 8, 6};
    c_options.filter = "mitchell";
    c_options.filter_use = EMULSION_SPLATTED;
    c_options.light_splats = 1;
    emulsion_film* got_film = nullptr;
    emulsion_tile* got_tile = nullptr;
    ASSERT_EQ(emulsion_film_create(&c_options, &got_film), EMULSION_OK) << emulsion_last_error();
    const FilmHandle got(got_film, emulsion_film_destroy);
    const PixelBounds places = film.sample_bounds();
    ASSERT_EQ(emulsion_tile_create(got_film, {places.x0, places.y0, places.x1, places.y1}, &got_tile), EMULSION_OK);
    const TileHandle tile_handle(got_tile, emulsion_tile_destroy);

    const Samples samples(4);
    std::vector<float> x, y;
    for (std::size_t i = 0; i < kCount; ++i) {
        x.push_back(static_cast<float>(samples.x[i]) + 0.5f * samples.triples[3 * i]);
        y.push_back(static_cast<float>(samples.y[i]) + 0.5f * samples.triples[3 * i + 1]);
    }
    FilmTile tile = film.make_tile(places);
    const RgbInput input(rgb_space("Rec2020"), 0.5);
    for (std::size_t i = 0; i < kCount; ++i) {
        SampledWavelengths<4> wavelengths;
        SampledSpectrum<4> radiance;
        for (std::size_t k = 0; k < 4; ++k) {
            wavelengths.lambda_nm[k] = samples.lambda_nm[4 * i + k];
            wavelengths.pdf[k] = samples.pdf[4 * i + k];
            radiance.value[k] = samples.radiance[4 * i + k];
        }
        const float* triple = &samples.triples[3 * i];
        tile.add_at(x[i], y[i], wavelengths, radiance);
        tile.add_at(x[i], y[i], XYZ{triple[0], triple[1], triple[2]});
        tile.add_at(x[i], y[i], input.to_xyz({triple[0], triple[1], triple[2]}));
        tile.splat(x[i], y[i], wavelengths, radiance);
        tile.splat(x[i], y[i], XYZ{triple[0], triple[1], triple[2]});
    }
    film.merge(tile);
    film.add_light_paths(700);

    const float *triples = samples.triples.data(), *lambda_nm = samples.lambda_nm.data(),
                *values = samples.radiance.data(), *pdf = samples.pdf.data();
    const auto expect_ok = [](emulsion_status status) { EXPECT_EQ(status, EMULSION_OK) << emulsion_last_error(); };
    expect_ok(emulsion_tile_add_at_spectral(got_tile, kCount, x.data(), y.data(), 4, lambda_nm, values, pdf));
    expect_ok(emulsion_tile_add_at_xyz(got_tile, kCount, x.data(), y.data(), triples));
    expect_ok(emulsion_tile_add_at_rgb(got_tile, kCount, x.data(), y.data(), "Rec2020", triples));
    expect_ok(emulsion_tile_splat_spectral(got_tile, kCount, x.data(), y.data(), 4, lambda_nm, values, pdf));
    expect_ok(emulsion_tile_splat_xyz(got_tile, kCount, x.data(), y.data(), triples));
    expect_ok(emulsion_film_merge_tile(got_film, got_tile));
    expect_ok(emulsion_film_add_light_paths(got_film, 700));

    std::vector<float> xyz(std::size_t{3} * 7 * 4);
    ASSERT_EQ(emulsion_film_read_xyz(got_film, xyz.data(), xyz.size()), EMULSION_OK) << emulsion_last_error();
    const Image<XYZ> image = film.xyz_image();
    std::size_t i = 0;
    for (const XYZ& pixel : image.pixels()) {
        ASSERT_EQ(pixel, (XYZ{xyz[i], xyz[i + 1], xyz[i + 2]})) << "pixel " << i / 3;
        i += 3;
    }
    EXPECT_GT(image(3, 2).y, 0.0f);

    const TemporaryFolder folder;
    ASSERT_EQ(emulsion_film_write_exr(got_film, folder.file("crop.exr").c_str(), nullptr, nullptr), EMULSION_OK);
    EXPECT_EQ(read_exr(folder.file("crop.exr")).data_window, (PixelBounds{1, 2, 8, 6}));
}

/// A wavelength that nobody sees counts as one that carries nothing.
TEST(Capi, InvisibleWavelengthsCarryNothing) {
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
        std::vector<float>& xyz = pictures.emplace_back(std::size_t{3} * kWidth_px * kHeight_px);
        ASSERT_EQ(emulsion_film_read_xyz(film.get(), xyz.data(), xyz.size()), EMULSION_OK);
    }
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_GT(pictures[0][std::size_t{3} * (kTile.y0 * kWidth_px + kTile.x0) + 1], 0.0f);
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

TEST(Capi, FilesAreThoseOfCpp) {
    const TemporaryFolder folder;
    const FilmHandle film = c_film();
    const TileHandle tile = c_tile(film);
    ASSERT_EQ(add_in_c(tile, Samples(4), 4), EMULSION_OK);
    ASSERT_EQ(emulsion_film_merge_tile(film.get(), tile.get()), EMULSION_OK);
    emulsion_exr_options options;
    ASSERT_EQ(emulsion_exr_options_init(&options, sizeof options), EMULSION_OK);
    options.renderer_version = "capi_test 1";
    ASSERT_EQ(emulsion_film_write_exr(film.get(), folder.file("c.exr").c_str(), &options, nullptr), EMULSION_OK);

    const FilmImage read = read_exr(folder.file("c.exr"));
    EXPECT_EQ(read.white_luminance_cdm2, 2.0);  // an imaging ratio of 0.5
    EXPECT_EQ(read.metadata.sample_count, kCount);
    EXPECT_EQ(read.metadata.renderer_version, "capi_test 1");
    std::vector<float> xyz(std::size_t{3} * kWidth_px * kHeight_px);
    ASSERT_EQ(emulsion_film_read_xyz(film.get(), xyz.data(), xyz.size()), EMULSION_OK);
    std::size_t i = 0;
    for (const XYZ& pixel : read.xyz.pixels()) {
        EXPECT_EQ(pixel, (XYZ{2.0f * xyz[i], 2.0f * xyz[i + 1], 2.0f * xyz[i + 2]}));
        i += 3;
    }
}

TEST(Capi, ExceptionsBecomeCodes) {
    using capi::guarded;
    EXPECT_EQ(guarded([] {}), EMULSION_OK);
    EXPECT_EQ(guarded([] { throw std::invalid_argument("what is wrong"); }), EMULSION_INVALID_ARGUMENT);
    EXPECT_STREQ(emulsion_last_error(), "what is wrong");
    EXPECT_EQ(guarded([] { throw IoError("file", "why"); }), EMULSION_IO_ERROR);
    EXPECT_STREQ(emulsion_last_error(), "file: why");
    EXPECT_EQ(guarded([] { throw std::bad_alloc(); }), EMULSION_OUT_OF_MEMORY);
    EXPECT_EQ(guarded([] { static_cast<void>(std::vector<int>(static_cast<std::size_t>(-1))); }),
              EMULSION_OUT_OF_MEMORY);
    EXPECT_EQ(guarded([] { throw std::runtime_error("unforeseen"); }), EMULSION_INTERNAL_ERROR);
    EXPECT_STREQ(emulsion_last_error(), "unforeseen");
    EXPECT_EQ(guarded([] { throw 1; }), EMULSION_INTERNAL_ERROR);
    EXPECT_EQ(guarded([] { throw std::runtime_error(std::string(5000, 'x')); }), EMULSION_INTERNAL_ERROR);
    EXPECT_EQ(std::string(emulsion_last_error()), std::string(2047, 'x'));
}

TEST(Capi, ErrorsBelongToTheirThread) {
    EXPECT_EQ(emulsion_tile_clear(nullptr), EMULSION_INVALID_ARGUMENT);
    std::thread([] { EXPECT_STREQ(emulsion_last_error(), ""); }).join();
    EXPECT_STREQ(emulsion_last_error(), "tile is NULL");
}

}  // namespace
}  // namespace emulsion
