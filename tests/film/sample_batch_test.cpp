// Batches of samples are, bit for bit, their samples one by one: for every use of a filter, number of wavelengths and
// kind of sum.

#include "film/sample_batch.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "film/film.h"
#include "filter_examples.h"
#include "sample_batch_fixture.h"

namespace emulsion {
namespace {

using emulsion::testing::BatchSamples;
using emulsion::testing::name_of;

constexpr std::size_t kCount = 200;

FilmOptions film_options(const Filter& filter, FilterUse use) {
    return {.width_px = 12,
            .height_px = 9,
            .sensor = {.exposure_time_s = 0.1, .iso = 400.0},
            .crop = PixelBounds{1, 2, 11, 8},
            .filter = filter,
            .filter_use = use,
            .light_splats = true,
            .variance = FilmVariance::xyz,
            .spectrum = SpectralBuckets{.count = 3, .min_nm = 400.0, .max_nm = 700.0},
            .firefly_control = LuminanceClamp{.max_luminance_cdm2 = 1e4f}};
}

/// Inside the film, and smaller than it.
constexpr PixelBounds kPlaces{3, 2, 10, 7};

/// A film with what `fill(tile)` puts into one tile of it.
template <class Sums, class Fill>
FilmContents<Sums> gathered(const FilmOptions& options, const Fill& fill) {
    BasicFilm<Sums> film(options);
    BasicFilmTile<Sums> tile = film.make_tile(kPlaces);
    fill(tile);
    film.merge(tile);
    return film.contents();
}

/// All kinds of samples, one by one and in the order of add_batches; spectra of so many wavelengths, or of fewer as
/// ones of N.
template <int N, class Sums>
void add_one_by_one(BasicFilmTile<Sums>& tile, const BatchSamples& samples, FilterUse use) {
    const auto for_each = [&](const auto& add) {
        for (std::size_t i = 0; i < samples.count(); ++i) add(i, samples.x_px[i], samples.y_px[i]);
    };
    const auto wavelengths = [&](std::size_t i) { return samples.template wavelengths_of<N>(i); };
    const auto radiance = [&](std::size_t i) { return samples.template radiance_of<N>(i); };
    if (use == FilterUse::splatted) {
        for_each([&](std::size_t i, float x, float y) { tile.add_at(x, y, wavelengths(i), radiance(i)); });
        for_each([&](std::size_t i, float x, float y) { tile.add_at(x, y, samples.xyz(i)); });
    } else {
        const auto &x = samples.x, &y = samples.y;
        const auto& weight = samples.weight;
        for_each([&](std::size_t i, float, float) { tile.add(x[i], y[i], wavelengths(i), radiance(i), weight[i]); });
        for_each([&](std::size_t i, float, float) { tile.add(x[i], y[i], wavelengths(i), radiance(i), 1.0f); });
        for_each([&](std::size_t i, float, float) { tile.add(x[i], y[i], samples.xyz(i), weight[i]); });
    }
    // Half of them miss the tile.
    for_each([&](std::size_t i, float x, float y) { tile.splat(x + 4.0f, y, wavelengths(i), radiance(i)); });
    for_each([&](std::size_t i, float x, float y) { tile.splat(x + 4.0f, y, samples.xyz(i)); });
}

template <class Sums>
void add_batches(BasicFilmTile<Sums>& tile, const BatchSamples& samples, FilterUse use) {
    if (use == FilterUse::splatted) {
        add_batch_at(tile, samples.places(), samples.spectra());
        add_batch_at(tile, samples.places(), samples.xyz_of());
    } else {
        add_batch(tile, samples.pixels(), samples.spectra());
        add_batch(tile, {samples.x, samples.y, {}}, samples.spectra());
        add_batch(tile, samples.pixels(), samples.xyz_of());
    }
    std::vector<float> x_px = samples.x_px;
    for (float& x : x_px) x += 4.0f;
    splat_batch(tile, {x_px, samples.y_px}, samples.spectra());
    splat_batch(tile, {x_px, samples.y_px}, samples.xyz_of());
}

template <int N, class Sums>
FilmContents<Sums> one_by_one(const FilmOptions& options, const BatchSamples& samples) {
    return gathered<Sums>(options, [&](auto& tile) { add_one_by_one<N>(tile, samples, options.filter_use); });
}
template <class Sums>
FilmContents<Sums> in_batches(const FilmOptions& options, const BatchSamples& samples) {
    return gathered<Sums>(options, [&](auto& tile) { add_batches(tile, samples, options.filter_use); });
}

template <int N>
void expect_same(const FilmOptions& options, std::size_t wavelengths = N) {
    SCOPED_TRACE(name_of(options.filter) + ", " + std::to_string(wavelengths) + " wavelengths");
    const BatchSamples samples(kPlaces, wavelengths, kCount);
    const FilmContents<ExactSums> got = in_batches<ExactSums>(options, samples);
    EXPECT_TRUE((got == one_by_one<N, ExactSums>(options, samples)));
    EXPECT_GT(got.counts.samples, kCount);
    EXPECT_GT(got.counts.light_splats, kCount / 2);
    EXPECT_GT(got.counts.clamped.count, 0u);
    for (const DroppedKind kind : {DroppedKind::nan, DroppedKind::infinite, DroppedKind::negative_luminance}) {
        EXPECT_GT(got.counts.dropped.count(kind), 0u);
    }
}

template <class Sums>
void expect_same_picture(const FilmOptions& options) {
    const BatchSamples samples(kPlaces, 4, kCount);
    const FilmSetup setup(options);
    const auto picture = [&](FilmContents<Sums> contents) {
        contents.counts.light_paths = 1;
        return xyz_image(contents, setup);
    };
    EXPECT_EQ(picture(in_batches<Sums>(options, samples)), picture(one_by_one<4, Sums>(options, samples)));
}

constexpr std::array kBothUses = {FilterUse::importance_sampled, FilterUse::splatted};

TEST(SampleBatch, IsItsSamplesOneByOneForEveryFilter) {
    for (const FilterUse use : kBothUses) {
        for (const Filter& filter : testing::example_filters()) expect_same<4>(film_options(filter, use));
    }
}

TEST(SampleBatch, IsItsSamplesOneByOneForEveryNumberOfWavelengths) {
    for (const FilterUse use : kBothUses) {
        const FilmOptions options = film_options(MitchellFilter{}, use);
        for_each_wavelength_count([&]<int N>() { expect_same<N>(options); });
        expect_same<64>(options);
        expect_same<128>(options);
        expect_same<256>(options);
    }
}

// Wavelengths that carry nothing, and densities as much smaller: what the header says of other numbers.
TEST(SampleBatch, OtherNumbersOfWavelengthsGoAsTheNextLargerOne) {
    for (const FilterUse use : kBothUses) {
        const FilmOptions options = film_options(GaussianFilter{}, use);
        expect_same<4>(options, 3);
        expect_same<8>(options, 5);
        expect_same<16>(options, 9);
        expect_same<256>(options, 129);
    }
}

// Floats do not forgive another order.
TEST(SampleBatch, KeepsTheOrderOfItsSamples) {
    for (const FilterUse use : kBothUses) {
        expect_same_picture<FloatSums>(film_options(TriangleFilter{}, use));
        expect_same_picture<KahanFloatSums>(film_options(TriangleFilter{}, use));
    }
}

TEST(SampleBatch, GoesIntoTheGroupOfItsIndex) {
    FilmOptions options = film_options(BoxFilter{}, FilterUse::importance_sampled);
    options.firefly_control = MedianOfMeans{.groups = 3};
    const BatchSamples samples(kPlaces, 4, kCount);
    const auto expected = gathered<ExactSums>(options, [&](FilmTile& tile) {
        tile.set_sample_index(5);
        add_one_by_one<4>(tile, samples, options.filter_use);
    });
    const auto got = gathered<ExactSums>(options, [&](FilmTile& tile) {
        tile.set_sample_index(5);
        add_batches(tile, samples, options.filter_use);
    });
    EXPECT_TRUE(got == expected);
    const auto other =
        gathered<ExactSums>(options, [&](FilmTile& tile) { add_batches(tile, samples, options.filter_use); });
    EXPECT_FALSE(other == expected) << "of index 0";
}

// They don't stop what comes behind them, and are reported where they lie.
TEST(SampleBatch, BadSamplesInTheMiddleAreCountedWithTheirPixels) {
    const std::array<std::int32_t, 5> x = {3, 9, 4, 5, 3}, y = {2, 6, 2, 2, 2};
    const std::array<float, 5> x_px = {3.5f, 9.9f, 4.0f, 5.25f, 3.5f}, y_px = {2.5f, 6.5f, 2.0f, 2.75f, 2.5f};
    const std::array<float, 5> lambda_nm = {555.0f, 555.0f, 555.0f, 555.0f, 555.0f};
    const std::array<float, 5> pdf = {0.01f, 0.01f, 0.01f, 0.01f, 0.01f};
    const std::array<float, 5> radiance = {1.0f, -1.0f, HUGE_VALF, std::nanf(""), 1.0f};
    for (const FilterUse use : kBothUses) {
        for (const bool is_light : {false, true}) {
            FilmOptions options = film_options(BoxFilter{}, use);
            const auto contents = gathered<ExactSums>(options, [&](FilmTile& tile) {
                const BatchRadiance spectra{1, lambda_nm, radiance, pdf};
                if (is_light) return splat_batch(tile, {x_px, y_px}, spectra);
                if (use == FilterUse::splatted) return add_batch_at(tile, {x_px, y_px}, spectra);
                add_batch(tile, {x, y, {}}, spectra);
            });
            EXPECT_EQ(is_light ? contents.counts.light_splats : contents.counts.samples, 2u);
            const auto dropped = contents.counts.dropped.first();
            ASSERT_EQ(dropped.size(), 3u);
            const std::array kinds = {DroppedKind::infinite, DroppedKind::nan, DroppedKind::negative_luminance};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t at = std::array{2, 3, 1}[i];  // in reading order
                EXPECT_EQ(dropped[i].x_px, x[at]);
                EXPECT_EQ(dropped[i].y_px, y[at]);
                EXPECT_EQ(dropped[i].kind, kinds[i]);
            }
        }
    }
}

}  // namespace
}  // namespace emulsion
