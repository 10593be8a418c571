// The layers of a film's picture, each from its own source.

#include "film/film_layers.h"

#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film_state_fixture.h"

namespace emulsion {
namespace {

using emulsion::testing::add_samples;
using emulsion::testing::every_film;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> names_of(const FilmPicture& picture) {
    std::vector<std::string> names;
    for (const FloatChannel& channel : picture.floats) names.push_back(channel.name);
    for (const CountChannel& channel : picture.counts) names.push_back(channel.name);
    return names;
}

TEST(FilmLayers, AreWhatTheOptionsAskFor) {
    const auto names = [](const FilmOptions& options) { return names_of(picture_of(Film(options))); };
    const FilmOptions plain{.width_px = 2, .height_px = 1};
    EXPECT_THAT(names(plain), IsEmpty());
    FilmOptions options = plain;
    options.variance = FilmVariance::luminance;
    EXPECT_THAT(names(options), ElementsAre("variance.Y", "standard-error.Y", "samples"));
    options.variance = FilmVariance::xyz;
    EXPECT_THAT(names(options), ElementsAre("variance.X", "standard-error.X", "variance.Y", "standard-error.Y",
                                            "variance.Z", "standard-error.Z", "samples"));
    options = plain;
    options.aux = {known_aux_layer("albedo"), known_aux_layer("depth")};
    EXPECT_THAT(names(options), ElementsAre("albedo.R", "albedo.G", "albedo.B", "depth.Z", "samples"));
    options = plain;
    options.spectrum = SpectralBuckets{.count = 4, .min_nm = 400.0, .max_nm = 600.0};
    EXPECT_THAT(names(options), ElementsAre("samples"));
    const FilmPicture picture = picture_of(Film(options));
    ASSERT_EQ(picture.spectral.size(), 4u);
    EXPECT_EQ(picture.spectral[1].centre_nm, 475.0);
    EXPECT_EQ(picture.spectral[1].width_nm, 50.0);
    EXPECT_EQ(picture.spectral[1].values(1, 0), 0.0f) << "no sample has reached it";
}

TEST(FilmLayers, HaveTheValuesOfThePixels) {
    Film film(every_film()[1].options);
    add_samples(film, 0, 20);
    const FilmPicture picture = picture_of(film);
    EXPECT_EQ(picture.xyz, film.xyz_image());
    EXPECT_EQ(picture.data_window, film.bounds());
    EXPECT_EQ(picture.width_px, film.options().width_px);
    EXPECT_EQ(picture.height_px, film.options().height_px);
    const std::uint64_t paths = film.counts().light_paths;
    bool has_variance = false, has_spectrum = false, has_depth = false;
    film.for_each_pixel([&](std::size_t i, const PixelSums& sums) {
        const auto layer = [&](std::size_t number) { return picture.floats[number].values.pixels()[i]; };
        const PixelVariance variance = variance_of(sums, film.setup());
        EXPECT_EQ(layer(0), static_cast<float>(variance.variance.x));
        EXPECT_EQ(layer(3), static_cast<float>(variance.standard_error.y));
        EXPECT_EQ(layer(4), static_cast<float>(variance.variance.z));
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(layer(6 + k), static_cast<float>(aux_value_of(sums, film.setup(), 0, k)));
            EXPECT_EQ(
                picture.spectral[k].values.pixels()[i],
                static_cast<float>(bucket_radiance_of(sums, film.setup(), static_cast<int>(k), paths).value_or(0.0)));
        }
        EXPECT_EQ(layer(9), static_cast<float>(aux_value_of(sums, film.setup(), 1, 0)));
        EXPECT_EQ(picture.counts[0].values.pixels()[i], sums.samples);
        has_variance = has_variance || layer(0) > 0.0f;
        has_spectrum = has_spectrum || picture.spectral[0].values.pixels()[i] > 0.0f;
        has_depth = has_depth || layer(9) != 0.0f;
    });
    EXPECT_TRUE(has_variance && has_spectrum && has_depth) << "the film is too tame";
}

}  // namespace
}  // namespace emulsion
