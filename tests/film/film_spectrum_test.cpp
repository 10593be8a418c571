// Spectral buckets: the same samples, sorted by wavelength.

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

constexpr SpectralBuckets kBuckets{16, 380.0, 780.0};  // of 25 nm

FilmOptions spectral() { return {.width_px = 1, .height_px = 1, .spectrum = kBuckets}; }

std::vector<std::optional<double>> radiances(const Film& film) {
    std::vector<std::optional<double>> all;
    const std::uint64_t paths = film.counts().light_paths;
    film.for_each_pixel([&](std::size_t, const PixelSums& sums) {
        for (int b = 0; b < kBuckets.count; ++b) all.push_back(bucket_radiance_of(sums, film.setup(), b, paths));
    });
    return all;
}

/// Radiance that rises with the wavelength, seen by `paths` paths of N wavelengths.
template <int N>
void add_ramp(Film& film, int paths, bool as_light) {
    FilmTile tile = film.make_tile(film.bounds());
    const VisibleWavelengthPdf distribution;
    Pcg32 random(2);
    for (int i = 0; i < paths; ++i) {
        const auto wavelengths = hero_wavelengths<N>(distribution, random.next_float());
        SampledSpectrum<N> radiance;
        for (int k = 0; k < N; ++k) radiance[k] = wavelengths.lambda_nm[static_cast<std::size_t>(k)] / 500.0f;
        if (as_light) {
            tile.splat(0.5f, 0.5f, wavelengths, radiance);
        } else {
            tile.add(0, 0, wavelengths, radiance, 1.0f);
        }
    }
    film.merge(tile);
    if (as_light) film.add_light_paths(static_cast<std::uint64_t>(paths));
}

// A bucket has the mean of the ramp within it. Samples are uneven inside a bucket of 25 nm only by the density's own
// slope there, so that 4,000 of them leave the ramp's spread, 0.029 half-width, over the root of some hundreds.
TEST(FilmSpectrum, BucketsHaveTheMeanRadiance) {
    Film film(spectral());
    add_ramp<4>(film, 4000, false);
    const auto found = radiances(film);
    for (int b = 0; b < kBuckets.count; ++b) {
        ASSERT_TRUE(found[static_cast<std::size_t>(b)].has_value());
        EXPECT_NEAR(*found[static_cast<std::size_t>(b)], kBuckets.centre_nm(b) / 500.0, 0.005) << b;
    }
}

// The same units for light splats, whose estimate has the noise of how many wavelengths a bucket gets: about 5 % in the
// rarest, of 4 * 40,000 / 16 / 40 = 250 wavelengths, and 0.3 % in the usual ones.
TEST(FilmSpectrum, LightSplatsHaveTheSameUnits) {
    FilmOptions options = spectral();
    options.light_splats = true;
    Film film(options);
    add_ramp<4>(film, 40000, true);
    const auto found = radiances(film);
    for (int b = 1; b + 3 < kBuckets.count; ++b) {
        const double expected = kBuckets.centre_nm(b) / 500.0;
        EXPECT_NEAR(*found[static_cast<std::size_t>(b)], expected, 0.06 * expected) << b;
    }
}

TEST(FilmSpectrum, ConstantRadianceIsThatConstantWithFewSamples) {
    Film film(spectral());
    FilmTile tile = film.make_tile(film.bounds());
    for (const float u : {0.1f, 0.35f, 0.8f}) {
        tile.add(0, 0, hero_wavelengths<8>(VisibleWavelengthPdf{}, u), SampledSpectrum<8>(0.7f), 1.0f);
    }
    film.merge(tile);
    int filled = 0;
    for (const std::optional<double>& value : radiances(film)) {
        if (!value) continue;
        ++filled;
        EXPECT_NEAR(*value, 0.7, 1e-6);
    }
    EXPECT_GE(filled, 8);
    EXPECT_LT(filled, 16) << "24 wavelengths do not find all";
}

// Wavelengths that a renderer has ended have density 0; what the others carry is not thinned by them.
TEST(FilmSpectrum, EndedWavelengthsCarryNothing) {
    Film film(spectral());
    FilmTile tile = film.make_tile(film.bounds());
    const SampledWavelengths<2> wavelengths{{500.0f, 600.0f}, {0.5f / 400.0f, 0.0f}};
    tile.add(0, 0, wavelengths, SampledSpectrum<2>(3.0f), 1.0f);
    film.merge(tile);
    const auto found = radiances(film);
    EXPECT_NEAR(found[4].value(), 3.0, 1e-6);
    EXPECT_FALSE(found[8].has_value());
    EXPECT_EQ(film.dropped().count(), 0u);
}

TEST(FilmSpectrum, EndsBelongToTheFirstBucketAndToNone) {
    Film film(spectral());
    FilmTile tile = film.make_tile(film.bounds());
    const float last = std::nextafter(780.0f, 0.0f);
    const SampledWavelengths<4> wavelengths{{380.0f, last, 780.0f, 379.99f}, {0.01f, 0.01f, 0.01f, 0.01f}};
    tile.add(0, 0, wavelengths, SampledSpectrum<4>(1.0f), 1.0f);
    film.merge(tile);
    const auto found = radiances(film);
    EXPECT_TRUE(found[0].has_value());
    EXPECT_TRUE(found[15].has_value());
    for (std::size_t b = 1; b < 15; ++b) EXPECT_FALSE(found[b].has_value());
}

TEST(FilmSpectrum, XyzIsThatOfAFilmWithoutBuckets) {
    Film with(spectral()), without({.width_px = 1, .height_px = 1});
    add_ramp<4>(with, 100, false);
    add_ramp<4>(without, 100, false);
    EXPECT_EQ(with.xyz_image(), without.xyz_image());
}

// A sample that is kept out adds to no bucket, and one that is scaled down adds that much less.
TEST(FilmSpectrum, FollowsTheJudgementOfTheSample) {
    FilmOptions options = spectral();
    options.firefly_control = LuminanceClamp{1.0f};
    Film film(options);
    FilmTile tile = film.make_tile(film.bounds());
    const SampledWavelengths<1> green{{555.0f}, {1.0f}};
    tile.add(0, 0, green, SampledSpectrum<1>(-1.0f), 1.0f);
    tile.add(0, 0, green, SampledSpectrum<1>(std::nanf("")), 1.0f);
    tile.add(0, 0, green, SampledSpectrum<1>(1.0f), std::nanf(""));
    tile.add(0, 0, green, SampledSpectrum<1>(10.0f), 1.0f);
    film.merge(tile);
    EXPECT_EQ(film.dropped().count(), 3u);
    // 683 * 10 * ybar(555) cd/m^2 are brought down to 1.
    EXPECT_NEAR(radiances(film)[7].value(), 10.0 / (683.0 * 10.0), 1e-5);
    EXPECT_NEAR(static_cast<double>(film.xyz_image()(0, 0).y), 1.0, 1e-6);
}

}  // namespace
}  // namespace emulsion
