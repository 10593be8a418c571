// What a film has beside its picture, through the C interface: bit for bit the layers of the C++ interface, in memory
// and in files.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capi/emulsion.h"
#include "capi_fixture.h"
#include "film/exr_file.h"
#include "film/film.h"
#include "film/film_layers.h"
#include "film/film_metadata.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::c_film;
using testing::c_options;
using testing::c_tile;
using testing::cpp_options;
using testing::expect_ok;
using testing::expect_same;
using testing::FilmHandle;
using ::testing::HasSubstr;
using testing::kCount;
using testing::kTile;
using testing::Samples;
using testing::TileHandle;

/// The same options twice.
struct Options {
    FilmOptions cpp = cpp_options();
    emulsion_film_options c = c_options();
};

Options with_layers() {
    Options both;
    both.cpp.filter = MitchellFilter{};
    both.c.filter = "mitchell";
    both.cpp.variance = FilmVariance::xyz;
    both.c.variance = EMULSION_VARIANCE_XYZ;
    both.cpp.spectrum = SpectralBuckets{.count = 5, .min_nm = 400.0, .max_nm = 650.0};
    both.c.spectrum_count = 5;
    both.c.spectrum_min_nm = 400.0;
    both.c.spectrum_max_nm = 650.0;
    both.cpp.aux = {known_aux_layer("normal"), {"id", {"value"}}};
    both.c.aux = "normal,id:value";
    return both;
}

std::vector<Options> every_kind() {
    std::vector<Options> kinds(5, with_layers());
    kinds[1].cpp.firefly_control = LuminanceClamp{.max_luminance_cdm2 = 1500.0f};
    kinds[1].c.firefly_control = "clamp:luminance=1500";
    kinds[2].cpp.firefly_control = MedianOfMeans{.groups = 3};
    kinds[2].c.firefly_control = "median-of-means:groups=3";
    kinds[3].cpp.variance = FilmVariance::luminance;
    kinds[3].c.variance = EMULSION_VARIANCE_LUMINANCE;
    for (const std::size_t splatted : {1u, 4u}) {
        kinds[splatted].cpp.filter_use = FilterUse::splatted;
        kinds[splatted].c.filter_use = EMULSION_SPLATTED;
        kinds[splatted].cpp.light_splats = true;
        kinds[splatted].c.light_splats = 1;
    }
    kinds[4].cpp.crop = PixelBounds{1, 2, 8, 6};
    kinds[4].c.crop = {1, 2, 8, 6};
    return kinds;
}

/// Normals, among which are some that are not finite, and numbers.
struct Seen {
    std::vector<float> normals, ids;
    explicit Seen(const Samples& samples)
        : normals(samples.triples), ids(samples.pdf.begin(), samples.pdf.begin() + kCount) {
        for (std::size_t i = 0; i < normals.size(); i += 50) normals[i] = std::nanf("");
    }
};

/// So many rounds of samples, each of another index.
void fill(Film& film, std::uint64_t rounds) {
    const bool is_splatted = film.options().filter_use == FilterUse::splatted;
    FilmTile tile = film.make_tile(kTile);
    for (std::uint64_t round = 0; round < rounds; ++round) {
        const Samples samples(4, round);
        const Seen seen(samples);
        tile.set_sample_index(round);
        for (std::size_t i = 0; i < kCount; ++i) {
            const auto wavelengths = samples.wavelengths_of<4>(i);
            const auto radiance = samples.radiance_of<4>(i);
            const std::span<const float> normal(&seen.normals[3 * i], 3), id(&seen.ids[i], 1);
            const int x = samples.x[i], y = samples.y[i];
            const float x_px = samples.x_px[i], y_px = samples.y_px[i], weight = samples.weight[i];
            if (is_splatted) {
                tile.add_at(x_px, y_px, wavelengths, radiance);
                tile.add_aux_at(x_px, y_px, 0, normal);
                tile.add_aux_at(x_px, y_px, 1, id);
                tile.splat(x_px, y_px, wavelengths, radiance);
            } else {
                tile.add(x, y, wavelengths, radiance, weight);
                tile.add_aux(x, y, 0, normal, weight);
                tile.add_aux(x, y, 1, id, 1.0f);
            }
        }
    }
    film.merge(tile);
    if (is_splatted) film.add_light_paths(1000);
}

/// The same.
void fill(const FilmHandle& film, FilterUse use, std::uint64_t rounds) {
    const TileHandle handle = c_tile(film);
    emulsion_tile* const tile = handle.get();
    for (std::uint64_t round = 0; round < rounds; ++round) {
        const Samples samples(4, round);
        const Seen seen(samples);
        const float *const lambda_nm = samples.lambda_nm.data(), *const radiance = samples.radiance.data(),
                           *const pdf = samples.pdf.data();
        expect_ok(emulsion_tile_set_sample_index(tile, round));
        if (use == FilterUse::splatted) {
            const float *const x = samples.x_px.data(), *const y = samples.y_px.data();
            expect_ok(emulsion_tile_add_at_spectral(tile, kCount, x, y, 4, lambda_nm, radiance, pdf));
            expect_ok(emulsion_tile_add_aux_at(tile, kCount, x, y, "normal", seen.normals.data()));
            expect_ok(emulsion_tile_add_aux_at(tile, kCount, x, y, "id", seen.ids.data()));
            expect_ok(emulsion_tile_splat_spectral(tile, kCount, x, y, 4, lambda_nm, radiance, pdf));
        } else {
            const std::int32_t *const x = samples.x.data(), *const y = samples.y.data();
            const float* const weight = samples.weight.data();
            expect_ok(emulsion_tile_add_spectral(tile, kCount, x, y, weight, 4, lambda_nm, radiance, pdf));
            expect_ok(emulsion_tile_add_aux(tile, kCount, x, y, weight, "normal", seen.normals.data()));
            expect_ok(emulsion_tile_add_aux(tile, kCount, x, y, nullptr, "id", seen.ids.data()));
        }
    }
    expect_ok(emulsion_film_merge_tile(film.get(), tile));
    if (use == FilterUse::splatted) expect_ok(emulsion_film_add_light_paths(film.get(), 1000));
}

constexpr std::uint64_t kRounds = 12;

/// The images' numbers pixel by pixel, as the C interface has them.
template <class T>
std::vector<T> interleaved(const std::vector<const Image<T>*>& images) {
    std::vector<T> numbers;
    for (std::size_t i = 0; i < images[0]->pixels().size(); ++i) {
        for (const Image<T>* const image : images) numbers.push_back(image->pixels()[i]);
    }
    return numbers;
}

std::vector<float> layers_named(const FilmPicture& picture, const std::vector<std::string>& names) {
    std::vector<const Image<float>*> images;
    for (const std::string& name : names) {
        for (const FloatChannel& channel : picture.floats) {
            if (channel.name == name) images.push_back(&channel.values);
        }
    }
    EXPECT_EQ(images.size(), names.size());
    return interleaved(images);
}

std::vector<float> spectrum_of(const FilmPicture& picture) {
    std::vector<const Image<float>*> images;
    for (const SpectralChannel& channel : picture.spectral) images.push_back(&channel.values);
    return interleaved(images);
}

/// What `read` puts into as many numbers as are expected.
template <class T, class Read>
void expect_read(const std::vector<T>& expected, const Read& read) {
    std::vector<T> got(expected.size(), T(77));
    expect_ok(read(got.data(), got.size()));
    EXPECT_EQ(got, expected);
    EXPECT_NE(expected, std::vector<T>(expected.size())) << "nothing was tested";
}

TEST(CapiLayers, AreThoseOfCpp) {
    for (const Options& options : every_kind()) {
        SCOPED_TRACE(to_text(options.cpp));
        Film film(options.cpp);
        fill(film, kRounds);
        const FilmHandle got = c_film(options.c);
        fill(got, options.cpp.filter_use, kRounds);
        expect_same(got, film);
        EXPECT_GT(film.counts().dropped_aux, 0u);
        EXPECT_EQ(film.counts().clamped.count > 0, std::holds_alternative<LuminanceClamp>(options.cpp.firefly_control));

        const emulsion_film* const from = got.get();
        const FilmPicture picture = picture_of(film);
        const bool has_one = options.cpp.variance == FilmVariance::luminance;
        const auto errors = [&](const std::string& name) {
            return layers_named(
                picture, has_one ? std::vector{name + ".Y"} : std::vector{name + ".X", name + ".Y", name + ".Z"});
        };
        expect_read(errors("variance"),
                    [&](float* to, std::size_t n) { return emulsion_film_read_variance(from, to, n); });
        expect_read(errors("standard-error"),
                    [&](float* to, std::size_t n) { return emulsion_film_read_standard_error(from, to, n); });
        expect_read(layers_named(picture, {"normal.X", "normal.Y", "normal.Z"}),
                    [&](float* to, std::size_t n) { return emulsion_film_read_aux(from, "normal", to, n); });
        expect_read(layers_named(picture, {"id.value"}),
                    [&](float* to, std::size_t n) { return emulsion_film_read_aux(from, "id", to, n); });
        expect_read(spectrum_of(picture),
                    [&](float* to, std::size_t n) { return emulsion_film_read_spectrum(from, to, n); });
        expect_read(interleaved<std::uint32_t>({&picture.counts[0].values}),
                    [&](std::uint32_t* to, std::size_t n) { return emulsion_film_read_sample_counts(from, to, n); });
    }
}

TEST(CapiLayers, FilesAreThoseOfCpp) {
    const TemporaryFolder folder;
    for (const Options& options : every_kind()) {
        SCOPED_TRACE(to_text(options.cpp));
        Film film(options.cpp);
        fill(film, kRounds);
        const FilmHandle got = c_film(options.c);
        fill(got, options.cpp.filter_use, kRounds);
        emulsion_exr_options exr;
        expect_ok(emulsion_exr_options_init(&exr, sizeof exr));
        exr.space = "sRGB";
        exr.renderer_version = "capi_layers_test 1";
        expect_ok(emulsion_film_write_exr(got.get(), folder.file("c.exr").c_str(), &exr, nullptr));
        write_exr(folder.file("cpp.exr"), picture_of(film),
                  metadata_of(film, {.renderer_version = "capi_layers_test 1"}),
                  {.space = "sRGB", .white_luminance_cdm2 = white_luminance_cdm2(film.options().sensor)});
        EXPECT_TRUE(read_text(folder.file("c.exr")) == read_text(folder.file("cpp.exr")));
        const FilmImage read = read_exr(folder.file("c.exr"));
        EXPECT_EQ(read.data_window, film.bounds());
        EXPECT_EQ(read.spectral.size(), 5u);
        EXPECT_EQ(read.counts.size(), 1u);
        EXPECT_THAT(read.metadata.film, HasSubstr("aux=normal:X+Y+Z,id:value"));
        EXPECT_EQ(read.metadata.firefly_control.empty(),
                  std::holds_alternative<NoFireflyControl>(options.cpp.firefly_control));
    }
}

// Median of means: of one group, of which there are samples in all, the means are other ones.
TEST(CapiLayers, SampleIndexChoosesTheGroup) {
    emulsion_film_options options = c_options();
    options.firefly_control = "median-of-means:groups=3";
    const std::array<std::int32_t, 1> x = {3}, y = {3};
    std::vector<std::vector<float>> pictures;
    for (const bool takes_turns : {false, true}) {
        const FilmHandle film = c_film(options);
        const TileHandle tile = c_tile(film);
        for (const std::uint64_t index : {0u, 1u, 2u}) {
            const std::array xyz = {1.0f, index == 1 ? 1000.0f : 1.0f, 1.0f};  // a firefly
            if (takes_turns) expect_ok(emulsion_tile_set_sample_index(tile.get(), index));
            expect_ok(emulsion_tile_add_xyz(tile.get(), 1, x.data(), y.data(), nullptr, xyz.data()));
        }
        expect_ok(emulsion_film_merge_tile(film.get(), tile.get()));
        std::vector<float>& xyz = pictures.emplace_back(testing::kXyzNumbers);
        expect_ok(emulsion_film_read_xyz(film.get(), xyz.data(), xyz.size()));
    }
    const std::size_t luminance = 3 * (3 * testing::kWidth_px + 3) + 1;
    EXPECT_EQ(pictures[0][luminance], 334.0f);
    EXPECT_EQ(pictures[1][luminance], 1.0f);
}

}  // namespace
}  // namespace emulsion
