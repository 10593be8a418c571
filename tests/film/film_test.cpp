#include "film/film.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "film/filter_sampler.h"
#include "filter_examples.h"
#include "spectrum/observer.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

FilmOptions options(int width_px, int height_px) { return {width_px, height_px, {}}; }

TEST(Film, ValidatesItsOptions) {
    const auto expect_refused = [](const FilmOptions& bad, const char* message) {
        EXPECT_THAT([&] { const Film film(bad); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(message), HasSubstr("expected"))));
    };
    expect_refused({.width_px = 0, .height_px = 4}, "width_px is 0");
    expect_refused({.width_px = 4, .height_px = -3}, "height_px is -3");
    expect_refused({.width_px = 65537, .height_px = 4}, "width_px is 65537");
    EXPECT_THROW(Film({4, 4, {.iso = 0.0}}), std::invalid_argument);
}

TEST(Film, TilesMustLieInside) {
    Film film(options(8, 6));
    for (const PixelBounds& bad : {PixelBounds{-1, 0, 2, 2}, PixelBounds{0, 0, 9, 2}, PixelBounds{0, 5, 2, 7},
                                   PixelBounds{3, 3, 3, 4}, PixelBounds{0, 4, 2, 2}}) {
        EXPECT_THROW(static_cast<void>(film.make_tile(bad)), std::invalid_argument);
    }
    EXPECT_EQ(film.make_tile(film.bounds()).pixels().size(), 48u);

    const Film larger(options(9, 6));
    EXPECT_THROW(film.merge(larger.make_tile(larger.bounds())), std::invalid_argument);
}

// The tile's places are inside, and so are its sums alike; but its filter reaches pixels that the film has not, or its
// sensor saw another light.
TEST(Film, TilesOfOtherOptionsAreRefused) {
    FilmOptions whole = options(40, 40);
    whole.filter = TriangleFilter{};
    whole.filter_use = FilterUse::splatted;
    FilmOptions cut = whole;
    cut.crop = PixelBounds{10, 10, 20, 20};
    FilmOptions bright = whole;
    bright.sensor.iso = 200.0;
    Film film(cut);
    for (const FilmOptions& other : {whole, bright}) {
        const FilmTile tile = Film(other).make_tile({10, 10, 20, 20});
        EXPECT_THAT([&] { film.merge(tile); }, ThrowsMessage<std::invalid_argument>(HasSubstr("other options")));
    }
    film.merge(Film(cut).make_tile({10, 10, 20, 20}));
}

TEST(Film, MergesOfOtherFilmsSayWhatDiffers) {
    Film film(options(8, 6));
    const auto expect_refused = [&](const FilmOptions& other, const char* message) {
        EXPECT_THAT([&] { film.merge(Film(other)); }, ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
    };
    expect_refused({.width_px = 9, .height_px = 6}, "9x6");
    expect_refused({.width_px = 8, .height_px = 6, .crop = PixelBounds{1, 2, 3, 4}}, "[1, 3) x [2, 4)");
    expect_refused({.width_px = 8, .height_px = 6, .sensor = {.iso = 200.0}}, "iso=200");
    expect_refused({.width_px = 8, .height_px = 6, .light_splats = true}, "light-splats=yes");
}

TEST(Film, ContentsMustHaveItsSize) {
    FilmOptions with_squares = options(3, 2);
    with_squares.variance = FilmVariance::xyz;
    const Film film(with_squares);
    EXPECT_NO_THROW(Film(with_squares, film.contents()));
    FilmContents<ExactSums> contents = film.contents();
    contents.pixels.pop_back();
    EXPECT_THROW(Film(with_squares, contents), std::invalid_argument);
    contents = film.contents();
    contents.channels = ChannelSums(film.setup().channels, 5);
    EXPECT_THROW(Film(with_squares, contents), std::invalid_argument);
    EXPECT_THROW(Film(options(3, 2), film.contents()), std::invalid_argument);
}

TEST(Film, PixelIsTheWeightedMean) {
    Film film(options(4, 3));
    FilmTile tile = film.make_tile({1, 1, 3, 3});
    tile.add(2, 1, XYZ{1.0f, 2.0f, 3.0f}, 1.0f);
    tile.add(2, 1, XYZ{5.0f, 6.0f, 8.0f}, 3.0f);
    tile.add(1, 2, XYZ{7.0f, 7.0f, 7.0f}, -0.5f);
    tile.add(1, 2, XYZ{1.0f, 1.0f, 1.0f}, 1.5f);
    film.merge(tile);
    const Image<XYZ> image = film.xyz_image();
    EXPECT_EQ(image(2, 1), (XYZ{4.0f, 5.0f, 6.75f}));
    EXPECT_EQ(image(1, 2), (XYZ{-2.0f, -2.0f, -2.0f}));
    EXPECT_EQ(image(0, 0), XYZ{});
    EXPECT_EQ(film.pixels_without_value(), 10);
    EXPECT_EQ(film.sample_count(), 4u);
    EXPECT_EQ(film.min_samples_per_pixel(), 0u);
    EXPECT_EQ(film.max_samples_per_pixel(), 2u);
    EXPECT_EQ(film.saturated_pixels(), 0);
}

TEST(Film, ClearedTilesStartAnew) {
    Film film(options(2, 2));
    FilmTile tile = film.make_tile(film.bounds());
    tile.add(0, 0, XYZ{9.0f, 9.0f, 9.0f}, 1.0f);
    tile.add(0, 0, XYZ{kNan, 9.0f, 9.0f}, 1.0f);
    tile.clear();
    tile.add(0, 0, XYZ{1.0f, 2.0f, 3.0f}, 1.0f);
    film.merge(tile);
    EXPECT_EQ(film.xyz_image()(0, 0), (XYZ{1.0f, 2.0f, 3.0f}));
    EXPECT_EQ(film.dropped().count(), 0u);
    EXPECT_EQ(film.sample_count(), 1u);
}

// Weights of both signs that sum to nothing, or nearly: no infinities and no huge values.
TEST(Film, CancellingWeightsGiveNoValue) {
    Film film(options(4, 1));
    FilmTile tile = film.make_tile(film.bounds());
    const auto add = [&](int x, float value, float weight) { tile.add(x, 0, XYZ{value, value, value}, weight); };
    add(0, 5.0f, 1.0f), add(0, 1.0f, -1.0f);     // 0
    add(1, 5.0f, 1.0f), add(1, 1.0f, -0.999f);   // nearly 0
    add(2, 5.0f, -1.0f);                         // negative
    add(3, 5.0f, 1.0f), add(3, 1.0f, -0.9375f);  // small, but a mean of 1/32 still counts
    film.merge(tile);
    const Image<XYZ> image = film.xyz_image();
    for (int x = 0; x < 3; ++x) EXPECT_EQ(image(x, 0), XYZ{}) << x;
    EXPECT_FLOAT_EQ(image(3, 0).y, (5.0f - 0.9375f) / 0.0625f);
    EXPECT_EQ(film.pixels_without_value(), 3);
}

// A filter with negative lobes and few samples is where other renderers make pixels of 1e8.
TEST(Film, FewSamplesOfANegativeLobedFilterStayBounded) {
    Film film(options(100, 100));
    const FilterSampler sampler(LanczosSincFilter{});
    FilmTile tile = film.make_tile(film.bounds());
    Pcg32 random(1);
    for (int y = 0; y < 100; ++y) {
        for (int x = 0; x < 100; ++x) {
            for (int s = 0; s < 2; ++s) {
                const float value = random.next_float();
                tile.add(x, y, XYZ{value, value, value},
                         sampler.sample(random.next_float(), random.next_float()).weight);
            }
        }
    }
    film.merge(tile);
    float largest = 0.0f;
    const Image<XYZ> image = film.xyz_image();
    for (const XYZ& pixel : image.pixels()) largest = std::max(largest, std::abs(pixel.y));
    // A mean weight of at least 1/64, and |weight| < 3 for this filter.
    EXPECT_LT(largest, 3.0f * 64.0f);
    EXPECT_GT(film.pixels_without_value(), 0);
}

TEST(Film, ReconstructsAConstantUnderEveryFilter) {
    for (const Filter& filter : emulsion::testing::example_filters()) {
        Film film(options(4, 4));
        const FilterSampler sampler(filter);
        FilmTile tile = film.make_tile(film.bounds());
        Pcg32 random(2);
        for (int i = 0; i < 4 * 4 * 256; ++i) {
            tile.add(i % 4, i / 4 % 4, XYZ{0.3f, 40.0f, 5e6f},
                     sampler.sample(random.next_float(), random.next_float()).weight);
        }
        film.merge(tile);
        const Image<XYZ> image = film.xyz_image();
        for (const XYZ& pixel : image.pixels()) {
            EXPECT_NEAR(pixel.x, 0.3f, 0.3e-6f);
            EXPECT_NEAR(pixel.y, 40.0f, 40e-6f);
            EXPECT_NEAR(pixel.z, 5e6f, 5.0f);
        }
    }
}

TEST(Film, LargestFiniteSamplesAreKept) {
    Film film(options(1, 1));
    FilmTile tile = film.make_tile(film.bounds());
    constexpr float kLargest = std::numeric_limits<float>::max();
    tile.add(0, 0, XYZ{kLargest, kLargest, kLargest}, kLargest);
    EXPECT_EQ(tile.dropped().count(), 0u);
    film.merge(tile);
    EXPECT_EQ(film.saturated_pixels(), 1);
    EXPECT_TRUE(std::isfinite(film.xyz_image()(0, 0).x));
}

// 20,000 paths of 4 wavelengths in each of 16 pixels, against 683 times the 1 nm sum of the observer (trapezoids). 48
// tests have a false alarm in 1,000 runs together: each at 2.1e-5, |z| < 4.25. The standard error comes from the spread
// of the 16 pixels' own samples, taken once more.
TEST(Film, ConstantRadianceGivesTheIntegralOfTheObserver) {
    constexpr double kRadiance = 0.02;
    XYZd expected;
    const Observer& observer = cie_1931_2deg();
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        const bool end = lambda_nm == kMinWavelength_nm || lambda_nm == kMaxWavelength_nm;
        expected = expected + (683.0 * kRadiance * (end ? 0.5 : 1.0)) * eval(observer, lambda_nm);
    }

    Film film(options(4, 4));
    FilmTile tile = film.make_tile(film.bounds());
    const VisibleWavelengthPdf distribution;
    const SampledSpectrum<4> radiance(static_cast<float>(kRadiance));
    constexpr int kPaths = 20000;
    Pcg32 random(5);
    XYZd squares;
    for (int pixel = 0; pixel < 16; ++pixel) {
        for (int path = 0; path < kPaths; ++path) {
            const auto wavelengths = hero_wavelengths<4>(distribution, random.next_float());
            tile.add(pixel % 4, pixel / 4, wavelengths, radiance, 1.0f);
            const XYZd sample = film.sensor().to_xyz_reference(wavelengths, radiance);
            const auto squared = [](double deviation) { return deviation * deviation / (16.0 * kPaths); };
            squares = squares + XYZd{squared(sample.x - expected.x), squared(sample.y - expected.y),
                                     squared(sample.z - expected.z)};
        }
    }
    film.merge(tile);
    const Image<XYZ> image = film.xyz_image();
    for (const XYZ& pixel : image.pixels()) {
        const auto tolerance = [](double variance) { return 4.25 * std::sqrt(variance / kPaths); };
        EXPECT_NEAR(static_cast<double>(pixel.x), expected.x, tolerance(squares.x));
        EXPECT_NEAR(static_cast<double>(pixel.y), expected.y, tolerance(squares.y));
        EXPECT_NEAR(static_cast<double>(pixel.z), expected.z, tolerance(squares.z));
        EXPECT_LT(tolerance(squares.y), 0.01 * expected.y) << "too coarse to say anything";
    }
}

}  // namespace
}  // namespace emulsion
