#pragma once
// Films by both interfaces, and samples for them.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "capi/emulsion.h"
#include "core/random.h"
#include "film/film.h"
#include "spectrum/sampled_spectrum.h"

namespace emulsion::testing {

inline constexpr int kWidth_px = 9, kHeight_px = 7;
inline constexpr PixelBounds kTile{2, 1, 8, 7};
inline constexpr std::size_t kCount = 500;
/// Of all numbers X, Y, Z.
inline constexpr std::size_t kXyzNumbers = std::size_t{3} * kWidth_px * kHeight_px;

using FilmHandle = std::unique_ptr<emulsion_film, decltype(&emulsion_film_destroy)>;
using TileHandle = std::unique_ptr<emulsion_tile, decltype(&emulsion_tile_destroy)>;

/// With an imaging ratio of 0.5.
inline FilmOptions cpp_options() {
    FilmOptions options;
    options.width_px = kWidth_px;
    options.height_px = kHeight_px;
    options.sensor.exposure_time_s = 0.125;
    options.sensor.iso = 400.0;
    return options;
}

/// The same.
inline emulsion_film_options c_options() {
    emulsion_film_options options;
    EXPECT_EQ(emulsion_film_options_init(&options, sizeof options), EMULSION_OK);
    options.width_px = kWidth_px;
    options.height_px = kHeight_px;
    options.exposure_time_s = 0.125;
    options.iso = 400.0;
    return options;
}

inline void expect_ok(emulsion_status status) { EXPECT_EQ(status, EMULSION_OK) << emulsion_last_error(); }

inline FilmHandle c_film(const emulsion_film_options& options = c_options()) {
    emulsion_film* film = nullptr;
    expect_ok(emulsion_film_create(&options, &film));
    return {film, emulsion_film_destroy};
}

inline TileHandle c_tile(const FilmHandle& film, const PixelBounds& places = kTile) {
    emulsion_tile* tile = nullptr;
    expect_ok(emulsion_tile_create(film.get(), {places.x0, places.y0, places.x1, places.y1}, &tile));
    return {tile, emulsion_tile_destroy};
}

/// Random samples for pixels of the tile.
struct Samples {
    std::vector<std::int32_t> x, y;
    std::vector<float> x_px, y_px;  // in those pixels
    std::vector<float> weight, lambda_nm, radiance, pdf, triples;

    explicit Samples(std::size_t wavelengths, std::uint64_t seed = 1) {
        Pcg32 random(seed);
        for (std::size_t i = 0; i < kCount; ++i) {
            x.push_back(kTile.x0 + static_cast<int>(random.next_float() * static_cast<float>(kTile.width())));
            y.push_back(kTile.y0 + static_cast<int>(random.next_float() * static_cast<float>(kTile.height())));
            x_px.push_back(static_cast<float>(x.back()) + 0.5f * random.next_float());
            y_px.push_back(static_cast<float>(y.back()) + 0.5f * random.next_float());
            weight.push_back(random.next_float() < 0.1f ? -0.5f : 1.1f);
            for (std::size_t k = 0; k < wavelengths; ++k) {
                lambda_nm.push_back(360.0f + 470.0f * random.next_float());
                radiance.push_back(random.next_float());
                pdf.push_back(0.001f + 0.01f * random.next_float());
            }
            for (int k = 0; k < 3; ++k) triples.push_back(random.next_float());
        }
    }

    [[nodiscard]] XYZ triple(std::size_t i) const { return {triples[3 * i], triples[3 * i + 1], triples[3 * i + 2]}; }
    template <int N>
    [[nodiscard]] SampledWavelengths<N> wavelengths_of(std::size_t i) const {
        SampledWavelengths<N> wavelengths;
        for (std::size_t k = 0; k < N; ++k) {
            wavelengths.lambda_nm[k] = lambda_nm[N * i + k];
            wavelengths.pdf[k] = pdf[N * i + k];
        }
        return wavelengths;
    }
    template <int N>
    [[nodiscard]] SampledSpectrum<N> radiance_of(std::size_t i) const {
        SampledSpectrum<N> spectrum;
        for (std::size_t k = 0; k < N; ++k) spectrum.value[k] = radiance[N * i + k];
        return spectrum;
    }
};

template <int N>
void add_in_cpp(FilmTile& tile, const Samples& samples) {
    for (std::size_t i = 0; i < kCount; ++i) {
        tile.add(samples.x[i], samples.y[i], samples.wavelengths_of<N>(i), samples.radiance_of<N>(i),
                 samples.weight[i]);
    }
}

inline emulsion_status add_in_c(const TileHandle& tile, const Samples& samples, std::size_t wavelengths) {
    return emulsion_tile_add_spectral(tile.get(), kCount, samples.x.data(), samples.y.data(), samples.weight.data(),
                                      wavelengths, samples.lambda_nm.data(), samples.radiance.data(),
                                      samples.pdf.data());
}

/// The pixels, and all counts.
inline void expect_same(const FilmHandle& got, const Film& expected) {
    const Image<XYZ> image = expected.xyz_image();
    std::vector<float> xyz(3 * image.pixels().size());
    ASSERT_EQ(emulsion_film_read_xyz(got.get(), xyz.data(), xyz.size()), EMULSION_OK) << emulsion_last_error();
    std::size_t i = 0;
    for (const XYZ& pixel : image.pixels()) {
        ASSERT_EQ(pixel, (XYZ{xyz[i], xyz[i + 1], xyz[i + 2]})) << "pixel " << i / 3;
        i += 3;
    }
    const FilmCounts counts = expected.counts();
    std::uint64_t count = 0;
    expect_ok(emulsion_film_sample_count(got.get(), &count));
    EXPECT_EQ(count, counts.samples);
    expect_ok(emulsion_film_pixels_without_value(got.get(), &count));
    EXPECT_EQ(count, static_cast<std::uint64_t>(expected.pixels_without_value()));
    expect_ok(emulsion_film_dropped_aux_count(got.get(), &count));
    EXPECT_EQ(count, counts.dropped_aux);
    expect_ok(emulsion_film_clamped_count(got.get(), &count));
    EXPECT_EQ(count, counts.clamped.count);
}

}  // namespace emulsion::testing
