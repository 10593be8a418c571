// What is wrong with a batch is found before its first sample is added.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/aux_batch.h"
#include "film/film.h"
#include "film/sample_batch.h"

namespace emulsion {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

FilmOptions film_options(FilterUse use) {
    return {.width_px = 4,
            .height_px = 3,
            .filter_use = use,
            .light_splats = true,
            .aux = {known_aux_layer("depth"), known_aux_layer("normal")}};
}

/// Two good samples, to be spoiled.
struct Batch {
    std::vector<std::int32_t> x = {0, 3}, y = {2, 1};
    std::vector<float> x_px = {0.5f, 3.5f}, y_px = {2.5f, 1.5f}, weight = {1.0f, 1.0f};
    std::vector<float> lambda_nm = {500.0f, 510.0f, 520.0f, 530.0f}, radiance = {1.0f, 1.0f, 1.0f, 1.0f};
    std::vector<float> pdf = {0.01f, 0.01f, 0.01f, 0.01f};
    std::size_t wavelengths = 2, layer = 1;
    std::vector<float> values = std::vector<float>(6, 0.5f);

    [[nodiscard]] BatchPixels pixels() const { return {x, y, weight}; }
    [[nodiscard]] BatchPlaces places() const { return {x_px, y_px}; }
    [[nodiscard]] BatchRadiance spectra() const { return {wavelengths, lambda_nm, radiance, pdf}; }
    [[nodiscard]] BatchAux aux() const { return {layer, values}; }
};

constexpr auto kOne = [](std::size_t) noexcept { return XYZ{1.0f, 1.0f, 1.0f}; };

/// add(tile) is refused with that text, and adds nothing.
template <class Add>
void expect_refused(FilterUse use, const std::string& text, const Add& add) {
    Film film(film_options(use));
    FilmTile tile = film.make_tile(film.bounds());
    EXPECT_THAT([&] { add(tile); }, ThrowsMessage<std::invalid_argument>(HasSubstr(text)));
    film.merge(tile);
    EXPECT_TRUE(film.contents() == Film(film_options(use)).contents()) << text;
}
template <class Add>
void expect_sampled_refused(const std::string& text, const Add& add) {
    expect_refused(FilterUse::importance_sampled, text, add);
}
template <class Add>
void expect_splatted_refused(const std::string& text, const Add& add) {
    expect_refused(FilterUse::splatted, text, add);
}

void expect_pixels_refused(const Batch& batch, const std::string& text) {
    expect_sampled_refused(text, [&](FilmTile& tile) { add_batch(tile, batch.pixels(), batch.spectra()); });
    expect_sampled_refused(text, [&](FilmTile& tile) { add_batch(tile, batch.pixels(), kOne); });
    expect_sampled_refused(text, [&](FilmTile& tile) { add_aux_batch(tile, batch.pixels(), batch.aux()); });
}
void expect_camera_places_refused(const Batch& batch, const std::string& text) {
    expect_splatted_refused(text, [&](FilmTile& tile) { add_batch_at(tile, batch.places(), batch.spectra()); });
    expect_splatted_refused(text, [&](FilmTile& tile) { add_batch_at(tile, batch.places(), kOne); });
    expect_splatted_refused(text, [&](FilmTile& tile) { add_aux_batch_at(tile, batch.places(), batch.aux()); });
}
void expect_light_places_refused(const Batch& batch, const std::string& text) {
    expect_splatted_refused(text, [&](FilmTile& tile) { splat_batch(tile, batch.places(), batch.spectra()); });
    expect_splatted_refused(text, [&](FilmTile& tile) { splat_batch(tile, batch.places(), kOne); });
}
void expect_spectra_refused(const Batch& batch, const std::string& text) {
    expect_sampled_refused(text, [&](FilmTile& tile) { add_batch(tile, batch.pixels(), batch.spectra()); });
    expect_splatted_refused(text, [&](FilmTile& tile) { add_batch_at(tile, batch.places(), batch.spectra()); });
    expect_splatted_refused(text, [&](FilmTile& tile) { splat_batch(tile, batch.places(), batch.spectra()); });
}
void expect_aux_refused(const Batch& batch, const std::string& text) {
    expect_sampled_refused(text, [&](FilmTile& tile) { add_aux_batch(tile, batch.pixels(), batch.aux()); });
    expect_splatted_refused(text, [&](FilmTile& tile) { add_aux_batch_at(tile, batch.places(), batch.aux()); });
}

template <class Spoil>
Batch spoiled(const Spoil& spoil) {
    Batch batch;
    spoil(batch);
    return batch;
}

TEST(SampleBatchChecks, ArraysHaveOneLength) {
    for (const std::size_t length : {0u, 1u, 3u}) {
        const std::string found = " has " + std::to_string(length) + " numbers, expected 2";
        expect_pixels_refused(spoiled([&](Batch& b) { b.y.resize(length); }), "y_px" + found);
        const Batch unlike = spoiled([&](Batch& b) { b.y_px.resize(length); });
        expect_camera_places_refused(unlike, "y_px" + found);
        expect_light_places_refused(unlike, "y_px" + found);
        // Without any, weights are 1.
        if (length > 0) expect_pixels_refused(spoiled([&](Batch& b) { b.weight.resize(length); }), "weight" + found);
    }
    for (const std::size_t length : {0u, 3u, 5u}) {
        const std::string found = " has " + std::to_string(length) + " numbers, expected 4";
        expect_spectra_refused(spoiled([&](Batch& b) { b.lambda_nm.resize(length); }), "lambda_nm" + found);
        expect_spectra_refused(spoiled([&](Batch& b) { b.radiance.resize(length); }), "radiance" + found);
        expect_spectra_refused(spoiled([&](Batch& b) { b.pdf.resize(length); }), "pdf_per_nm" + found);
        expect_aux_refused(spoiled([&](Batch& b) { b.values.resize(length); }),
                           "values has " + std::to_string(length) + " numbers, expected 6");
    }
}

TEST(SampleBatchChecks, NumbersOfWavelengthsAndLayersAreInRange) {
    expect_spectra_refused(spoiled([](Batch& b) { b.wavelengths = 0; }), "wavelengths is 0, expected a number in");
    expect_spectra_refused(spoiled([](Batch& b) { b.wavelengths = 257; }), "wavelengths is 257, expected a number in");
    expect_spectra_refused(spoiled([](Batch& b) { b.wavelengths = 1; }), "lambda_nm has 4 numbers, expected 2");
    expect_aux_refused(spoiled([](Batch& b) { b.layer = 2; }),
                       "layer is 2, expected the number of one of the film's 2");
    expect_aux_refused(spoiled([](Batch& b) { b.layer = 0; }), "values has 6 numbers, expected 2");
}

TEST(SampleBatchChecks, SamplesLieInTheTile) {
    constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
    constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
    for (const std::int32_t x : {-1, 4, kLeast, kMost}) {
        expect_pixels_refused(spoiled([&](Batch& b) { b.x[1] = x; }), "sample 1 is at pixel (" + std::to_string(x) +
                                                                          ", 1), expected one inside [0, 4) x [0, 3)");
    }
    for (const std::int32_t y : {-1, 3, kLeast, kMost}) {
        expect_pixels_refused(spoiled([&](Batch& b) { b.y[0] = y; }), "sample 0 is at pixel (0, " + std::to_string(y));
    }
    for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF}) {
        expect_light_places_refused(spoiled([&](Batch& b) { b.x_px[1] = bad; }), "sample 1 is at (");
        expect_light_places_refused(spoiled([&](Batch& b) { b.y_px[0] = bad; }), "sample 0 is at (");
    }
    for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF, -0.01f, 4.01f}) {
        expect_camera_places_refused(spoiled([&](Batch& b) { b.x_px[1] = bad; }), "sample 1 is at (");
        expect_camera_places_refused(spoiled([&](Batch& b) { b.y_px[0] = bad; }), "sample 0 is at (");
    }
}

// Their edges belong to a tile's places; what a light path sends elsewhere is no error.
TEST(SampleBatchChecks, GoodOnesPass) {
    Film film(film_options(FilterUse::splatted));
    FilmTile tile = film.make_tile(film.bounds());
    const std::array edges_x = {0.0f, 4.0f}, edges_y = {0.0f, 3.0f}, far = {-100.0f, 1e30f};
    EXPECT_NO_THROW(add_batch_at(tile, {edges_x, edges_y}, kOne));
    EXPECT_NO_THROW(splat_batch(tile, {far, far}, kOne));
    EXPECT_EQ(tile.sample_count(), 2u);
    EXPECT_EQ(tile.light_splat_count(), 0u);
}

TEST(SampleBatchChecks, OfNoSamplesAddsNone) {
    const Batch none{.x = {},
                     .y = {},
                     .x_px = {},
                     .y_px = {},
                     .weight = {},
                     .lambda_nm = {},
                     .radiance = {},
                     .pdf = {},
                     .values = {}};
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        Film film(film_options(use));
        FilmTile tile = film.make_tile(film.bounds());
        if (use == FilterUse::splatted) {
            add_batch_at(tile, none.places(), none.spectra());
            add_batch_at(tile, none.places(), kOne);
            add_aux_batch_at(tile, none.places(), none.aux());
        } else {
            add_batch(tile, none.pixels(), none.spectra());
            add_batch(tile, none.pixels(), kOne);
            add_aux_batch(tile, none.pixels(), none.aux());
        }
        splat_batch(tile, none.places(), none.spectra());
        splat_batch(tile, none.places(), kOne);
        film.merge(tile);
        EXPECT_TRUE(film.contents() == Film(film_options(use)).contents());
    }
    const std::array weight = {1.0f};
    EXPECT_THROW(validate(BatchPixels{{}, {}, weight}, PixelBounds{0, 0, 1, 1}), std::invalid_argument);
}

// A tile whose places are out of the film's reach holds no pixels: none may be written.
TEST(SampleBatchChecks, BoundsWithoutPixelsTakeNone) {
    const std::array<std::int32_t, 3> x = {0, -5, 100}, y = {0, -5, 100};
    for (const PixelBounds& bounds : {PixelBounds{}, PixelBounds{3, 0, 3, 5}, PixelBounds{0, 3, 5, 3},
                                      PixelBounds{7, 0, 4, 5}, PixelBounds{0, 7, 5, 4}}) {
        EXPECT_THAT(
            [&] {
                validate(BatchPixels{x, y, {}}, bounds);
            },
            ThrowsMessage<std::invalid_argument>(HasSubstr("sample 0 is at pixel (0, 0)")));
        EXPECT_NO_THROW(validate(BatchPixels{}, bounds));
    }

    const auto setup = std::make_shared<const FilmSetup>(film_options(FilterUse::importance_sampled));
    FilmTile tile({100, 100, 101, 101}, setup);
    ASSERT_LT(tile.bounds().width(), 1);
    EXPECT_THROW(add_batch(tile, {x, y, {}}, kOne), std::invalid_argument);
    EXPECT_NO_THROW(add_batch(tile, BatchPixels{}, kOne));
}

}  // namespace
}  // namespace emulsion
