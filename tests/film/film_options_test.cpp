#include "film/film_options.h"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/film.h"

namespace emulsion {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

void expect_refused(const FilmOptions& bad, const char* message, const char* expected) {
    EXPECT_THAT([&] { const Film film(bad); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(message), HasSubstr(expected))));
}

TEST(FilmOptions, CropLiesInTheFrame) {
    FilmOptions options{.width_px = 8, .height_px = 6};
    for (const PixelBounds& bad : {PixelBounds{-1, 0, 2, 2}, PixelBounds{0, 0, 9, 2}, PixelBounds{3, 3, 3, 4},
                                   PixelBounds{0, 4, 2, 2}, PixelBounds{0, 0, 2, 7}}) {
        options.crop = bad;
        expect_refused(options, to_string(bad).c_str(), "expected pixels inside [0, 8) x [0, 6)");
    }
    options.crop = PixelBounds{2, 1, 8, 6};
    const Film film(options);
    EXPECT_EQ(film.bounds(), (PixelBounds{2, 1, 8, 6}));
    EXPECT_EQ(film.xyz_image().width(), 6);
    EXPECT_THROW(static_cast<void>(film.make_tile({0, 0, 4, 4})), std::invalid_argument);
}

TEST(FilmOptions, SpectraFiltersAndControlsAreValidated) {
    const auto with = [](auto set) {
        FilmOptions options{.width_px = 2, .height_px = 2};
        set(options);
        return options;
    };
    expect_refused(with([](auto& o) { o.spectrum = SpectralBuckets{0, 400.0, 700.0}; }), "spectrum.count", "[1, 1024]");
    expect_refused(with([](auto& o) {
                       o.spectrum = SpectralBuckets{4, 700.0, 400.0};
                   }),
                   "spectrum.min_nm", "[100, 400)");
    expect_refused(with([](auto& o) {
                       o.spectrum = SpectralBuckets{4, 99.0, 400.0};
                   }),
                   "spectrum.min_nm", "[100, 400)");
    expect_refused(with([](auto& o) { o.spectrum = SpectralBuckets{4, 400.0, 1001.0}; }), "spectrum.max_nm", "1000]");
    expect_refused(with([](auto& o) { o.spectrum = SpectralBuckets{100, 400.0, 400.9}; }), "width of a bucket", "0.01");
    expect_refused(with([](auto& o) { o.filter = BoxFilter{-1.0f, 1.0f}; }), "x-radius", "(0, inf)");
    expect_refused(with([](auto& o) { o.firefly_control = LuminanceClamp{0.0f}; }), "firefly control clamp",
                   "(0, inf)");
    expect_refused(with([](auto& o) { o.firefly_control = MedianOfMeans{2}; }), "groups", "[3, 63]");
    expect_refused(with([](auto& o) {
                       o.filter = BoxFilter{1e5f, 1.0f};
                       o.light_splats = true;
                   }),
                   "splatting: radius", "65536");
}

TEST(FilmOptions, AuxiliaryLayersAreValidated) {
    const auto with = [](std::vector<AuxLayer> layers) {
        return FilmOptions{.width_px = 2, .height_px = 2, .aux = std::move(layers)};
    };
    expect_refused(with({{"", {"R"}}}), "aux.name is \"\"", "letters");
    expect_refused(with({{"a.b", {"R"}}}), "aux.name is \"a.b\"", "letters");
    expect_refused(with({{"a", {"R"}}, {"a", {"G"}}}), "\"a\" twice", "different");
    for (const char* taken : {"variance", "standard-error", "S0"}) {
        expect_refused(with({{taken, {"Y"}}}), taken, "that the film's files don't have");
    }
    expect_refused(with({{"a", {}}}), "aux \"a\": components has 0", "1 to 16");
    expect_refused(with({{"a", std::vector<std::string>(17, "x")}}), "has 17", "1 to 16");
    expect_refused(with({{"a", {"R", "R"}}}), "twice", "different");
    expect_refused(with({{"a", {"R", "G,B"}}}), "\"G,B\"", "letters");
    EXPECT_NO_THROW(Film(with(known_aux_layers())));
    EXPECT_EQ(known_aux_layer("normal").components.size(), 3u);
    EXPECT_THAT([] { static_cast<void>(known_aux_layer("norml")); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("normal")));
}

TEST(FilmOptions, TextTellsAllOfThem) {
    EXPECT_EQ(to_text(FilmOptions{}),
              "filter=box:x-radius=0.5,y-radius=0.5 filter-use=importance-sampled light-splats=no variance=none "
              "spectrum=none aux=none firefly-control=none");
    FilmOptions options;
    options.filter_use = FilterUse::splatted;
    options.light_splats = true;
    options.variance = FilmVariance::xyz;
    options.spectrum = SpectralBuckets{16, 400.0, 700.0};
    options.aux = {known_aux_layer("albedo"), known_aux_layer("depth")};
    options.firefly_control = MedianOfMeans{7};
    EXPECT_EQ(to_text(options),
              "filter=box:x-radius=0.5,y-radius=0.5 filter-use=splatted light-splats=yes variance=xyz "
              "spectrum=16:400-700 aux=albedo:R+G+B,depth:Z firefly-control=median-of-means:groups=7");
}

TEST(FilmOptions, MemoryIs48BytesAPixelAnd64WithVariance) {
    const auto bytes = [](const FilmOptions& options) {
        const Film film(options);
        const FilmContents<ExactSums> contents = film.contents();
        return contents.pixels.size() * sizeof(contents.pixels[0]) + contents.channels.all_sums().size_bytes() +
               contents.channels.all_squares().size_bytes();
    };
    FilmOptions options{.width_px = 10, .height_px = 10};
    EXPECT_EQ(bytes(options), 4800u);
    options.variance = FilmVariance::luminance;
    EXPECT_EQ(bytes(options), 6400u);
    options.variance = FilmVariance::xyz;
    EXPECT_EQ(bytes(options), 9600u);
    options.filter = GaussianFilter{};
    EXPECT_EQ(bytes(options), 9600u);

    // Filters with negative lobes take sums of squared weights besides.
    options.filter = MitchellFilter{};
    EXPECT_EQ(bytes(options), 14400u);
    options.variance = FilmVariance::luminance;
    EXPECT_EQ(bytes(options), 8800u);
    options.variance = FilmVariance::none;
    EXPECT_EQ(bytes(options), 4800u);
}

}  // namespace
}  // namespace emulsion
