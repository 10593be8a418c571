#include "spectrum/oklab.h"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "spectrum/chromaticity.h"

namespace emulsion {
namespace {

struct Pair {
    XYZd xyz;
    Oklab oklab;
};

// Ottosson's table of XYZ and Oklab pairs, to three decimals. The second to fourth have negative cones, so that they
// need the odd cube root.
constexpr std::array<Pair, 4> kPublished = {
    Pair{{0.950, 1.000, 1.089}, {1.000, 0.000, 0.000}}, Pair{{1.000, 0.000, 0.000}, {0.450, 1.236, -0.019}},
    Pair{{0.000, 1.000, 0.000}, {0.922, -0.671, 0.263}}, Pair{{0.000, 0.000, 1.000}, {0.153, -1.415, -0.449}}};

TEST(Oklab, OfThePublishedPairs) {
    for (const Pair& pair : kPublished) {
        const Oklab oklab = oklab_from_xyz(pair.xyz);
        EXPECT_NEAR(oklab.l, pair.oklab.l, 5e-4);
        EXPECT_NEAR(oklab.a, pair.oklab.a, 5e-4);
        EXPECT_NEAR(oklab.b, pair.oklab.b, 5e-4);
    }
}

// The example of the "colour" package (Mansencal et al.) for XYZ_to_Oklab; all numbers have 8 decimals.
TEST(Oklab, OfAPublishedExample) {
    const Oklab oklab = oklab_from_xyz({0.20654008, 0.12197225, 0.05136952});
    EXPECT_NEAR(oklab.l, 0.51634019, 1e-7);
    EXPECT_NEAR(oklab.a, 0.15469500, 1e-7);
    EXPECT_NEAR(oklab.b, 0.06289579, 1e-7);
}

TEST(Oklab, OfD65IsGreyToAFewTenThousandths) {
    const Oklab white = oklab_from_xyz(xyz_of(Chromaticity{0.3127, 0.329}));
    EXPECT_NEAR(white.l, 1.0, 1e-4);
    EXPECT_GT(std::hypot(white.a, white.b), 1e-6);  // not exactly: our header says so
    EXPECT_LT(std::hypot(white.a, white.b), 4e-4);
}

TEST(Oklab, IsUndoneToRounding) {
    for (const Pair& pair : kPublished) {
        const XYZd back = xyz_from_oklab(oklab_from_xyz(pair.xyz));
        EXPECT_NEAR(back.x, pair.xyz.x, 5e-15);
        EXPECT_NEAR(back.y, pair.xyz.y, 5e-15);
        EXPECT_NEAR(back.z, pair.xyz.z, 5e-15);
    }
}

TEST(Oklab, ScalesWithTheCubeRootAlsoBelowZero) {
    const Oklab one = oklab_from_xyz({0.2, 0.3, 0.1}), minus_eight = oklab_from_xyz({-1.6, -2.4, -0.8});
    EXPECT_NEAR(minus_eight.l, -2.0 * one.l, 1e-15);
    EXPECT_NEAR(minus_eight.a, -2.0 * one.a, 1e-15);
    EXPECT_NEAR(minus_eight.b, -2.0 * one.b, 1e-15);
}

}  // namespace
}  // namespace emulsion
