#include "film/rgb_input.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/film.h"

namespace emulsion {
namespace {

TEST(RgbInput, OneIsTheWhiteOfTheSpaceWithItsLuminance) {
    for (const char* name : {"sRGB", "Rec2020", "ACEScg_AP1", "DCI_P3"}) {
        const RgbSpace& space = rgb_space(name);
        const XYZd white = RgbInput(space, 0.25, 80.0).to_xyz_reference({1.0, 1.0, 1.0});
        EXPECT_NEAR(white.y, 20.0, 1e-12);
        EXPECT_NEAR(white.x / (white.x + white.y + white.z), space.white.x, 1e-12);
        EXPECT_NEAR(white.y / (white.x + white.y + white.z), space.white.y, 1e-12);
    }
}

TEST(RgbInput, FastPathFollowsItsTwin) {
    const RgbInput input(rgb_space("ACES2065_1_AP0"));
    Pcg32 random(1);
    for (int i = 0; i < 1000; ++i) {
        const RGB rgb{random.next_float() - 0.2f, 100.0f * random.next_float(), random.next_float()};
        const XYZ got = input.to_xyz(rgb);
        const XYZd expected = input.to_xyz_reference({double{rgb.r}, double{rgb.g}, double{rgb.b}});
        const double size = std::abs(double{rgb.r}) + std::abs(double{rgb.g}) + std::abs(double{rgb.b});
        EXPECT_NEAR(double{got.x}, expected.x, 4e-7 * size);
        EXPECT_NEAR(double{got.y}, expected.y, 4e-7 * size);
        EXPECT_NEAR(double{got.z}, expected.z, 4e-7 * size);
    }
}

// A film of RGB samples, read back in the same space.
TEST(RgbInput, ComesBackFromTheFilm) {
    Film film({.width_px = 1, .height_px = 1, .sensor = {.iso = 400.0}});
    const RgbSpace& space = rgb_space("Display_P3");
    const RgbInput input(space, film.sensor().imaging_ratio());
    FilmTile tile = film.make_tile(film.bounds());
    tile.add(0, 0, input.to_xyz({0.2f, 0.5f, 0.7f}), 1.0f);
    film.merge(tile);
    const XYZ xyz = film.xyz_image()(0, 0);
    const auto rgb = rgb_from_xyz(space) * std::array<double, 3>{double{xyz.x}, double{xyz.y}, double{xyz.z}};
    EXPECT_NEAR(rgb[0] / 4.0, 0.2, 1e-6);
    EXPECT_NEAR(rgb[1] / 4.0, 0.5, 1e-6);
    EXPECT_NEAR(rgb[2] / 4.0, 0.7, 1e-6);
}

TEST(RgbInput, RefusesWhatHasNoSize) {
    EXPECT_THROW(RgbInput(rgb_space("sRGB"), 0.0), std::invalid_argument);
    EXPECT_THROW(RgbInput(rgb_space("sRGB"), 1.0, std::nan("")), std::invalid_argument);
    EXPECT_THROW(RgbInput(rgb_space("sRGB"), 1e20, 1e20), std::invalid_argument) << "no float holds 1e40";
    EXPECT_THROW(RgbInput(rgb_space("sRGB"), 1e-20, 1e-20), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
