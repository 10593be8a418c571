// What films say about what was done against fireflies.

#include "film/film_metadata.h"

#include <cstdint>
#include <initializer_list>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/film.h"

namespace emulsion {
namespace {

using ::testing::HasSubstr;

/// One pixel's samples, in groups by their numbers.
void add(Film& film, std::initializer_list<float> luminances) {
    FilmTile tile = film.make_tile(film.bounds());
    std::uint64_t index = 0;
    for (const float y : luminances) {
        tile.set_sample_index(index++);
        tile.add(0, 0, XYZ{y, y, y}, 1.0f);
    }
    film.merge(tile);
}

// Exposed by 2: 30 cd/m^2 are stored as 60, and clamped to 20; the mean of 2, 4, 30 falls from 12 to 16 / 3.
TEST(FilmMetadata, StatesTheBiasOfClamping) {
    Film film({.width_px = 1,
               .height_px = 1,
               .sensor = {.iso = 200.0},
               .firefly_control = LuminanceClamp{.max_luminance_cdm2 = 10.0f}});
    add(film, {4.0f, 8.0f, 60.0f});
    EXPECT_EQ(metadata_of(film, {}).firefly_control,
              "clamp:luminance=10; 1 of 3 samples were scaled down; mean luminance lowered by 6.667 cd/m^2, 55.6 %");
}

// The groups' means are 2, 4 and 30: the median is 4, the mean 12.
TEST(FilmMetadata, StatesTheBiasOfMedians) {
    Film film({.width_px = 1, .height_px = 1, .sensor = {.iso = 200.0}, .firefly_control = MedianOfMeans{.groups = 3}});
    add(film, {4.0f, 8.0f, 60.0f});
    EXPECT_EQ(metadata_of(film, {}).firefly_control,
              "median-of-means:groups=3; mean luminance changed by -8 cd/m^2, -66.7 %");
}

TEST(FilmMetadata, SaysNothingWhereNothingIsDone) {
    Film film({.width_px = 1, .height_px = 1});
    EXPECT_EQ(metadata_of(film, {}).firefly_control, "");
    const Film empty({.width_px = 1, .height_px = 1, .firefly_control = LuminanceClamp{}});
    EXPECT_THAT(metadata_of(empty, {}).firefly_control, HasSubstr("0 of 0 samples"));
}

// A radius of 2 px reaches 16 pixels, from places up to 2 px outside: 8 x 8 of them for a film of 4 x 4.
TEST(FilmMetadata, SaysHowManySamplesAFilmThatSplatsWasGiven) {
    Film film({.width_px = 4,
               .height_px = 4,
               .filter = BoxFilter{.x_radius_px = 2.0f, .y_radius_px = 2.0f},
               .filter_use = FilterUse::splatted});
    FilmTile tile = film.make_tile(film.sample_bounds());
    for (int i = 0; i < 3 * 64; ++i) {
        const float x_px = 0.5f + static_cast<float>(film.sample_bounds().x0 + i % 8);
        tile.add_at(x_px, 0.5f + static_cast<float>(film.sample_bounds().y0 + i / 8 % 8), XYZ{1.0f, 1.0f, 1.0f});
    }
    film.merge(tile);
    ASSERT_EQ(film.sample_count(), 3u * 64u);
    EXPECT_EQ(film.min_samples_per_pixel(), 3u * 16u);
    EXPECT_EQ(metadata_of(film, {}).samples_per_pixel, 3);
    FilmProvenance provenance;
    provenance.samples.add(SampleRange{0, 2});
    provenance.partial = PartialRound{{2, 4}, 4, {1, 0, 0, 0}};
    EXPECT_EQ(metadata_of(film, provenance, {}).samples_per_pixel, 2);
    EXPECT_EQ(samples_taken(provenance), (SamplesTaken{2, 4}));
    EXPECT_EQ(samples_taken({}), SamplesTaken{});
}

TEST(FilmMetadata, KeepsWhatIsOfTheRun) {
    Film film({.width_px = 1, .height_px = 1, .filter = TriangleFilter{}});
    add(film, {1.0f, -1.0f});
    const FilmMetadata metadata =
        metadata_of(film, {.sample_count = 99, .seed = 3, .renderer_version = "r", .command_line = "c"});
    EXPECT_EQ(metadata.sample_count, 1u);
    EXPECT_EQ(metadata.samples_per_pixel, 1);
    EXPECT_EQ(metadata.dropped_negative_luminance_count, 1u);
    EXPECT_EQ(metadata.seed, 3u);
    EXPECT_EQ(metadata.renderer_version, "r");
    EXPECT_EQ(metadata.command_line, "c");
    EXPECT_THAT(metadata.filter, HasSubstr("triangle:"));
    EXPECT_EQ(metadata.film,
              "filter-use=importance-sampled light-splats=no variance=none spectrum=none aux=none firefly-control=none "
              "exposure-time=1 iso=100 observer=cie-1931-2deg white-balance=none camera=none");
}

}  // namespace
}  // namespace emulsion
