#include "spectrum/cie_1964_uvw.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

const XYZd kD65 = {0.95047, 1.0, 1.08883};

TEST(Cie1964Uvw, IsTheClosedFormAtSimpleColours) {
    // Cube roots that come out: 100 Y = 27 and 8 give W* = 58 and 33.
    const XYZd equal_energy = {1.0, 1.0, 1.0};
    EXPECT_NEAR(uvw_from_xyz({0.27, 0.27, 0.27}, equal_energy).w, 58.0, 1e-13);
    EXPECT_NEAR(uvw_from_xyz({0.27, 0.27, 0.27}, equal_energy).u, 0.0, 1e-13);
    // X, Y, Z = 0.16, 0.08, 0.08: u = 64/(16 + 120 + 24) = 0.4, v = 48/160 = 0.3.
    const Cie1964Uvw uvw = uvw_from_xyz({0.16, 0.08, 0.08}, equal_energy);
    EXPECT_NEAR(uvw.w, 33.0, 1e-13);
    EXPECT_NEAR(uvw.u, 13.0 * 33.0 * (0.4 - 4.0 / 19.0), 1e-12);
    EXPECT_NEAR(uvw.v, 13.0 * 33.0 * (0.3 - 6.0 / 19.0), 1e-12);
}

TEST(Cie1964Uvw, OfTheWhiteIsTheTop) {
    const Cie1964Uvw white = uvw_from_xyz(kD65, kD65);
    EXPECT_EQ(white.u, 0.0);
    EXPECT_EQ(white.v, 0.0);
    EXPECT_NEAR(white.w, 25.0 * std::pow(100.0, 1.0 / 3.0) - 17.0, 1e-13);
}

TEST(Cie1964Uvw, ComesBackOverACube) {
    Pcg32 random(5);
    const auto component = [&random] { return 2.0 * random.next_float() - 0.5; };
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const XYZd xyz = {component(), component(), component()};
        const Cie1964Uvw uvw = uvw_from_xyz(xyz, kD65);
        // Away from W* = 0, v = 0 and the colours at infinity, where the map has no inverse.
        if (std::abs(uvw.w) < 0.1 || std::abs(xyz.y) < 1e-3 || std::abs(xyz.x + 15.0 * xyz.y + 3.0 * xyz.z) < 1e-2)
            continue;
        const XYZd back = xyz_from_uvw(uvw, kD65);
        EXPECT_NEAR(back.x, xyz.x, 1e-10);
        EXPECT_NEAR(back.y, xyz.y, 1e-10);
        EXPECT_NEAR(back.z, xyz.z, 1e-10);
        ++compared;
    }
    EXPECT_GT(compared, 1900);
}

TEST(Cie1964Uvw, TakesBlackAsAGrey) {
    const Cie1964Uvw black = uvw_from_xyz({}, kD65);
    EXPECT_EQ(black, (Cie1964Uvw{-0.0, -0.0, -17.0}));
    EXPECT_EQ(xyz_from_uvw(black, kD65), XYZd{});
}

TEST(Cie1964Uvw, GoesOnBelowItsDomain) {
    // W* is 0 at 100 Y = (17/25)^3 = 0.314432, and a grey comes back even there.
    const double luminance = 0.00314432;
    const Cie1964Uvw meeting = uvw_from_xyz(luminance * kD65, kD65);
    EXPECT_NEAR(meeting.w, 0.0, 1e-13);
    EXPECT_NEAR(xyz_from_uvw({0.0, 0.0, 0.0}, kD65).x, luminance * kD65.x, 1e-15);
    EXPECT_FALSE(std::isfinite(xyz_from_uvw({1.0, 0.0, 0.0}, kD65).x));
    // Negative luminance: an odd cube root.
    EXPECT_NEAR(uvw_from_xyz(-0.08 * kD65, kD65).w, 25.0 * -2.0 - 17.0, 1e-12);
    // Colour without luminance: W* is that of black, and the inverse has nothing to scale by.
    const Cie1964Uvw dark = uvw_from_xyz({0.5, 0.0, 0.5}, kD65);
    EXPECT_EQ(dark.w, -17.0);
    EXPECT_FALSE(std::isfinite(xyz_from_uvw(dark, kD65).x));
    // A sum X + 15 Y + 3 Z of 0.
    EXPECT_FALSE(std::isfinite(uvw_from_xyz({15.0, -1.0, 0.0}, kD65).u));
}

}  // namespace
}  // namespace emulsion
