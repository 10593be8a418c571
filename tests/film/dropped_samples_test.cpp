#include "film/dropped_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "film/film.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(DroppedSamples, KeepsBadSamplesOutAndReportsThem) {
    Film film(FilmOptions{8, 8, {}});
    FilmTile tile = film.make_tile(film.bounds());
    tile.add(1, 1, XYZ{1.0f, 2.0f, 3.0f}, 1.0f);
    tile.add(1, 1, XYZ{kNan, 2.0f, 3.0f}, 1.0f);
    tile.add(1, 1, XYZ{1.0f, kNan, 3.0f}, 1.0f);
    tile.add(1, 1, XYZ{1.0f, 2.0f, 3.0f}, kNan);
    tile.add(1, 1, XYZ{kInfinity, 2.0f, kNan}, 1.0f);
    tile.add(1, 1, XYZ{1.0f, 2.0f, kInfinity}, 1.0f);
    tile.add(1, 1, XYZ{kInfinity, 2.0f, -kInfinity}, 0.0f);
    tile.add(1, 1, XYZ{1.0f, -kInfinity, 3.0f}, 1.0f);
    tile.add(1, 1, XYZ{1.0f, 2.0f, 3.0f}, kInfinity);
    tile.add(2, 1, XYZ{1.0f, -2.0f, 3.0f}, -1.0f);
    tile.add(1, 1, XYZ{-1.0f, 0.0f, -3.0f}, 1.0f);  // luminance 0: kept
    film.merge(tile);
    EXPECT_EQ(film.xyz_image()(1, 1), (XYZ{0.0f, 1.0f, 0.0f}));
    EXPECT_EQ(film.sample_count(), 2u);

    const DroppedSamples dropped = film.dropped();
    EXPECT_EQ(dropped.count(), 9u);
    EXPECT_EQ(dropped.count(DroppedKind::nan), 4u);
    EXPECT_EQ(dropped.count(DroppedKind::infinite), 4u);
    EXPECT_EQ(dropped.count(DroppedKind::negative_luminance), 1u);
    ASSERT_EQ(dropped.first().size(), 8u);
    EXPECT_EQ(dropped.first()[0].x_px, 1);
}

// The luminance overflows, and what the balanced sensor makes of the light does not.
TEST(DroppedSamples, AnInfiniteLuminanceIsInfinite) {
    Film film({.width_px = 1, .height_px = 1, .sensor = {.white_balance = WhiteBalance{TemperatureWhite{3000.0}}}});
    FilmTile tile = film.make_tile(film.bounds());
    SensorSample sample;
    const SampledWavelengths<1> yellow{{570.0f}, {1.0f}};
    SampledSpectrum<1> radiance(1e30f);
    while (std::isfinite(sample.luminance)) {
        radiance *= 1.001f;
        sample = film.sensor().sense(yellow, radiance);
    }
    ASSERT_TRUE(std::isfinite(sample.xyz.x) && std::isfinite(sample.xyz.y) && std::isfinite(sample.xyz.z));
    tile.add(0, 0, yellow, radiance, 1.0f);
    EXPECT_EQ(tile.sample_count(), 0u);
    EXPECT_EQ(tile.dropped().count(DroppedKind::infinite), 1u);
}

TEST(DroppedSamples, ReportsADroppedSampleInWords) {
    EXPECT_EQ(to_string(DroppedSample{3, 4, DroppedKind::negative_luminance, XYZ{1.0f, -2.0f, 0.5f}, 1.5f}),
              "pixel (3, 4): XYZ (1, -2, 0.5), weight 1.5: negative luminance");
}

TEST(DroppedSamples, AreRestoredInReadingOrderOnly) {
    DroppedSamples dropped;
    dropped.add({3, 1, DroppedKind::nan, {}, 1.0f});
    dropped.add({2, 4, DroppedKind::infinite, {}, 1.0f});
    const std::vector<DroppedSample> first(dropped.first().begin(), dropped.first().end());
    EXPECT_TRUE(DroppedSamples::restored({1, 5, 0}, first).first()[1].y_px == 4);
    const std::vector<DroppedSample> turned(first.rbegin(), first.rend());
    EXPECT_THROW(static_cast<void>(DroppedSamples::restored({1, 5, 0}, turned)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(DroppedSamples::restored({0, 5, 0}, first)), std::invalid_argument);
}

TEST(DroppedSamples, ReportedSamplesDoNotDependOnTheOrderOfMerges) {
    Film forwards(FilmOptions{16, 16, {}}), backwards(FilmOptions{16, 16, {}});
    std::vector<FilmTile> tiles;
    for (int y = 0; y < 16; y += 4) {
        FilmTile tile = forwards.make_tile({0, y, 16, y + 4});
        for (int x = 0; x < 5; ++x) tile.add(x, y, XYZ{0.0f, -1.0f - static_cast<float>(x), 0.0f}, 1.0f);
        tiles.push_back(tile);
    }
    for (const FilmTile& tile : tiles) forwards.merge(tile);
    std::for_each(tiles.rbegin(), tiles.rend(), [&](const FilmTile& tile) { backwards.merge(tile); });
    const DroppedSamples a = forwards.dropped(), b = backwards.dropped();
    EXPECT_EQ(a.count(), 20u);
    ASSERT_EQ(a.first().size(), 8u);
    ASSERT_EQ(b.first().size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_EQ(to_string(a.first()[i]), to_string(b.first()[i]));
        EXPECT_EQ(a.first()[i].y_px, i < 5 ? 0 : 4);
    }
}

}  // namespace
}  // namespace emulsion
