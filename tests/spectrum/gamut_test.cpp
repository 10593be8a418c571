#include "spectrum/gamut.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/random.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

XYZd xyz_of_rgb(const RgbSpace& space, double r, double g, double b) {
    const auto xyz = xyz_from_rgb(space) * std::array<double, 3>{r, g, b};
    return {xyz[0], xyz[1], xyz[2]};
}

TEST(RgbGamut, HasItsPrimariesOnTheBorderAndItsWhiteInside) {
    for (const std::string& name : data_table("rgb_colourspaces").row_names) {
        const RgbSpace& space = rgb_space(name);
        const RgbGamut gamut(space);
        for (const Chromaticity& primary : {space.red, space.green, space.blue}) {
            EXPECT_NEAR(gamut.signed_distance(primary), 0.0, 1e-16) << name;
        }
        EXPECT_GT(gamut.signed_distance(space.white), 0.05) << name;
        EXPECT_NEAR(gamut.margin(xyz_of_rgb(space, 0.5, 0.5, 0.5)), 0.5, 1e-14) << name;
        EXPECT_NEAR(gamut.margin(xyz_of(space.white)), 0.0, 1e-14) << name;
    }
}

TEST(RgbGamut, AgreesWithTheSignsOfRgb) {
    const RgbSpace& space = rgb_space("Display_P3");
    const RgbGamut gamut(space);
    Pcg32 random(11);
    const auto component = [&random] { return 1.6 * random.next_float() - 0.3; };
    for (int i = 0; i < 2000; ++i) {
        const RGBd rgb = {component(), component(), component()};
        const XYZd xyz = xyz_of_rgb(space, rgb.r, rgb.g, rgb.b);
        EXPECT_NEAR(gamut.margin(xyz), gamut_margin(rgb), 1e-14);
        if (!(xyz.x + xyz.y + xyz.z > 0.1)) continue;
        const bool mixes = rgb.r >= 0.0 && rgb.g >= 0.0 && rgb.b >= 0.0;
        EXPECT_EQ(gamut.signed_distance(chromaticity_of(xyz)) >= 0.0, mixes);
    }
}

TEST(RgbGamut, DoesntDependOnTheOrderOfItsPrimaries) {
    RgbSpace turned = rgb_space("sRGB");
    std::swap(turned.red, turned.blue);
    const RgbGamut gamut(rgb_space("sRGB")), other(turned);
    for (const Chromaticity& c : {Chromaticity{0.3, 0.3}, Chromaticity{0.2, 0.7}, Chromaticity{0.7, 0.2}}) {
        EXPECT_EQ(gamut.signed_distance(c), other.signed_distance(c));
    }
}

TEST(RgbGamut, OfSrgbLacksTheGreenOfDisplayP3) {
    const RgbGamut srgb(rgb_space("sRGB")), p3(rgb_space("Display_P3"));
    const Chromaticity green = rgb_space("Display_P3").green;
    // The triangle's nearest edge is that from (0.64, 0.33) to (0.30, 0.60): the distance by hand.
    const double length = std::hypot(0.34, 0.27);
    const double expected = ((0.265 - 0.64) * 0.27 + (0.69 - 0.33) * 0.34) / length;
    const double beyond_corner = std::hypot(0.265 - 0.30, 0.69 - 0.60);
    EXPECT_NEAR(srgb.signed_distance(green), -beyond_corner, 1e-15) << "the foot lies beyond the corner";
    EXPECT_LT(expected, beyond_corner);
    // Display P3 holds all of sRGB, whose blue it shares.
    EXPECT_GT(p3.signed_distance(rgb_space("sRGB").red), 0.01);
    EXPECT_GT(p3.signed_distance(rgb_space("sRGB").green), 0.01);
    EXPECT_NEAR(p3.signed_distance(rgb_space("sRGB").blue), 0.0, 1e-16);
}

TEST(GamutMargin, SaysByHowMuchTheWorstComponentIsOut) {
    EXPECT_EQ(gamut_margin({0.5, 0.5, 0.5}), 0.5);
    EXPECT_EQ(gamut_margin({0.25, 0.5, 0.5}), 0.25);
    EXPECT_EQ(gamut_margin({0.25, 0.5, 1.5}), -0.5);
    EXPECT_EQ(gamut_margin({-2.0, 0.5, 1.5}), -2.0);
    EXPECT_EQ(gamut_margin({0.0, 0.5, 1.0}), 0.0);
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(gamut_margin({kNaN, 0.5, 0.5})));
    EXPECT_TRUE(std::isnan(gamut_margin({0.5, 0.5, kNaN})));
    EXPECT_TRUE(std::isnan(RgbGamut(rgb_space("sRGB")).margin({kNaN, 0.5, 0.5})));
}

TEST(RgbGamut, NeedsATriangle) {
    RgbSpace line = rgb_space("sRGB");
    line.green = line.red;
    EXPECT_THROW((void)RgbGamut(line), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
