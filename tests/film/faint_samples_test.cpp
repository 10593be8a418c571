// Samples below the resolution of the sums: added as what they round to, and counted.

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "film/film.h"
#include "film/film_metadata.h"
#include "film/sample_batch.h"

namespace emulsion {
namespace {

constexpr float kHalf = 0x1p-45f;  // of the resolution of w Y; ties go to even, here to 0
const float kAbove = std::nextafter(kHalf, 1.0f);

XYZ grey(float luminance) { return {luminance, luminance, luminance}; }

/// What a film with one pixel has of one sample.
struct Seen {
    std::uint64_t faint = 0, samples = 0;
    double luminance = 0.0;
};
template <class Sums = ExactSums>
Seen seen(float luminance, float weight) {
    BasicFilm<Sums> film({.width_px = 1, .height_px = 1});
    BasicFilmTile<Sums> tile = film.make_tile(film.bounds());
    tile.add(0, 0, grey(luminance), weight);
    film.merge(tile);
    return {film.counts().faint, film.sample_count(), tile.pixels()[0].sums().xyz.y};
}

TEST(FaintSamples, AreThoseThatRoundToNothing) {
    for (const float luminance : {kHalf, 0.3f * kHalf, 1e-30f, std::numeric_limits<float>::denorm_min()}) {
        const Seen sample = seen(luminance, 1.0f);
        EXPECT_EQ(sample.faint, 1u) << luminance;
        EXPECT_EQ(sample.samples, 1u) << "they are no dropped samples";
        EXPECT_EQ(sample.luminance, 0.0);
    }
    EXPECT_EQ(seen(kAbove, 1.0f).faint, 0u);
    EXPECT_EQ(seen(kAbove, 1.0f).luminance, 0x1p-44);
    for (const float black : {0.0f, -0.0f}) {
        EXPECT_EQ(seen(black, 1.0f).faint, 0u);
        EXPECT_EQ(seen(black, 1.0f).samples, 1u);
    }
    EXPECT_EQ(seen(kHalf, -2.0f).faint, 1u) << "by the luminance, before the weight";
    EXPECT_EQ(seen(kHalf, -2.0f).luminance, -0x1p-44) << "as what they round to";
    EXPECT_EQ(seen(-kHalf, 1.0f).faint, 0u);
    EXPECT_EQ(seen(kHalf, std::nanf("")).faint, 0u) << "dropped";
    EXPECT_EQ(seen<DoubleSums>(kHalf, 1.0f).faint, 0u) << "nothing is lost there";
    EXPECT_EQ(seen<DoubleSums>(kHalf, 1.0f).luminance, 0x1p-45);
    EXPECT_EQ(seen<DoubleSums>(0.0f, 1.0f).samples, 1u);
}

TEST(FaintSamples, AreCountedOnEveryWay) {
    const FilmOptions drawn{.width_px = 2, .height_px = 2, .light_splats = true};
    FilmOptions spread = drawn;
    spread.filter = MitchellFilter{};
    spread.filter_use = FilterUse::splatted;
    Film drawn_film(drawn), spread_film(spread);
    FilmTile drawn_tile = drawn_film.make_tile(drawn_film.bounds());
    FilmTile spread_tile = spread_film.make_tile(spread_film.bounds());
    const SampledWavelengths<4> wavelengths{{500.0f, 520.0f, 550.0f, 600.0f}, {1.0f, 1.0f, 1.0f, 1.0f}};
    const std::array<std::int32_t, 4> x = {0, 1, 0, 1}, y = {0, 0, 1, 1};
    const std::array<float, 4> x_px = {0.5f, 0.6f, 1.7f, 1.9f}, y_px = {1.1f, 1.2f, 1.3f, 1.4f};
    const BatchPixels pixels{x, y, {}};
    const BatchPlaces places{x_px, y_px};
    // Of the four luminances of a batch, two are faint.
    const auto values = [](std::size_t i) noexcept { return grey(std::array<float, 4>{kHalf, 0.0f, 1e-20f, 1.0f}[i]); };
    std::array<float, 16> lambda_nm{}, radiance{}, pdf{};
    lambda_nm.fill(550.0f);
    pdf.fill(1.0f);
    radiance.fill(1.0f);
    radiance[0] = radiance[1] = radiance[2] = radiance[3] = 0.0f;
    radiance[4] = radiance[5] = radiance[6] = radiance[7] = 1e-20f;
    radiance[8] = radiance[9] = radiance[10] = radiance[11] = 1e-30f;
    const BatchRadiance spectra{4, lambda_nm, radiance, pdf};

    std::uint64_t drawn_count = 0, spread_count = 0;
    const auto expect_more = [&](std::uint64_t of_drawn, std::uint64_t of_spread, const char* way) {
        drawn_count += of_drawn;
        spread_count += of_spread;
        EXPECT_EQ(drawn_tile.faint_count(), drawn_count) << way;
        EXPECT_EQ(spread_tile.faint_count(), spread_count) << way;
    };
    for (const float size : {1e-25f, 1.0f, 0.0f}) {
        const std::uint64_t faint = size == 1e-25f ? 1 : 0;
        drawn_tile.add(0, 1, wavelengths, SampledSpectrum<4>(size), 1.0f);
        spread_tile.add_at(0.5f, 1.5f, wavelengths, SampledSpectrum<4>(size));
        expect_more(faint, faint, "a spectrum");
        spread_tile.add_at(0.5f, 1.5f, grey(size));
        expect_more(0, faint, "a place");
        drawn_tile.splat(0.5f, 1.5f, grey(size));
        spread_tile.splat(0.5f, 1.5f, wavelengths, SampledSpectrum<4>(size));
        expect_more(faint, faint, "light");
        drawn_tile.splat(9.5f, 1.5f, grey(size));
        expect_more(0, 0, "light that misses");
    }
    add_batch(drawn_tile, pixels, values);
    add_batch_at(spread_tile, places, values);
    expect_more(2, 2, "batches");
    add_batch(drawn_tile, pixels, spectra);
    add_batch_at(spread_tile, places, spectra);
    expect_more(2, 2, "batches of spectra");
    splat_batch(drawn_tile, places, values);
    splat_batch(spread_tile, places, spectra);
    expect_more(2, 2, "batches of light");

    drawn_film.merge(drawn_tile);
    drawn_film.merge(drawn_tile);
    Film other(drawn);
    other.merge(drawn_tile);
    drawn_film.merge(other);
    EXPECT_EQ(drawn_film.counts().faint, 3 * drawn_count);
    EXPECT_EQ(metadata_of(drawn_film, {}).faint_count, 3 * drawn_count);
    drawn_tile.clear();
    EXPECT_EQ(drawn_tile.faint_count(), 0u);
}

// What a clamp takes away is counted as that.
TEST(FaintSamples, AreNotThoseThatAClampMakesFaint) {
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        Film film({.width_px = 1,
                   .height_px = 1,
                   .filter_use = use,
                   .firefly_control = LuminanceClamp{.max_luminance_cdm2 = 1e-20f}});
        FilmTile tile = film.make_tile(film.bounds());
        for (const float luminance : {1.0f, 1e-25f, 0.0f}) {
            if (use == FilterUse::splatted) {
                tile.add_at(0.5f, 0.5f, grey(luminance));
            } else {
                tile.add(0, 0, grey(luminance), 1.0f);
            }
        }
        EXPECT_EQ(tile.faint_count(), 1u);
        EXPECT_EQ(tile.clamped().count, 1u);
        EXPECT_EQ(tile.sample_count(), 3u);
    }
}

}  // namespace
}  // namespace emulsion
