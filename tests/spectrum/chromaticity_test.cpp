#include "spectrum/chromaticity.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(Chromaticity, OfTheEqualEnergyColourIsExact) {
    const XYZd white = {2.0, 2.0, 2.0};
    EXPECT_EQ(chromaticity_of(white), (Chromaticity{1.0 / 3.0, 1.0 / 3.0}));
    EXPECT_EQ(uv_1976_of(white), (Uv1976{4.0 / 19.0, 9.0 / 19.0}));
    EXPECT_EQ(uv_1960_of(white), (Uv1960{4.0 / 19.0, 6.0 / 19.0}));
}

TEST(Chromaticity, GivesThePublishedUvOfIlluminants) {
    struct Case {
        Chromaticity xy;
        double u, v;  // u', v'
    };
    // CIE 15:2004, table T.3: A and D65, to four decimals.
    for (const Case& c : {Case{{0.44758, 0.40745}, 0.2560, 0.5243}, Case{{0.31272, 0.32903}, 0.1978, 0.4683}}) {
        EXPECT_NEAR(uv_1976_of(c.xy).u, c.u, 5e-5);
        EXPECT_NEAR(uv_1976_of(c.xy).v, c.v, 5e-5);
        EXPECT_DOUBLE_EQ(uv_1960_of(c.xy).u, uv_1976_of(c.xy).u);
        EXPECT_DOUBLE_EQ(uv_1960_of(c.xy).v, uv_1976_of(c.xy).v * 2.0 / 3.0);
    }
}

TEST(Chromaticity, ComesBackFromEverySystem) {
    Pcg32 random(3);
    for (int i = 0; i < 1000; ++i) {
        // Real and imaginary: y > 0.02 keeps away from where nothing comes back.
        const Chromaticity xy = {1.4 * random.next_float() - 0.2, 0.02 + random.next_float()};
        const double luminance = 100.0 * (random.next_float() - 0.5);
        const XYZd xyz = xyz_of(xy, luminance);
        EXPECT_EQ(xyz.y, luminance);
        for (const Chromaticity& back : {chromaticity_of(xyz), chromaticity_of(uv_1976_of(xy)),
                                         chromaticity_of(uv_1960_of(xy)), chromaticity_of(uv_1960_of(xyz))}) {
            EXPECT_NEAR(back.x, xy.x, 1e-13);
            EXPECT_NEAR(back.y, xy.y, 1e-13);
        }
        EXPECT_NEAR(uv_1976_of(xyz).u, uv_1976_of(xy).u, 1e-13);
        EXPECT_NEAR(uv_1976_of(xyz).v, uv_1976_of(xy).v, 1e-13);
    }
}

TEST(Chromaticity, OfBlackIsNone) {
    const Chromaticity black = chromaticity_of(XYZd{});
    EXPECT_TRUE(std::isnan(black.x) && std::isnan(black.y));
    EXPECT_TRUE(std::isnan(uv_1976_of(XYZd{}).u) && std::isnan(uv_1976_of(XYZd{}).v));
    EXPECT_TRUE(std::isnan(uv_1960_of(XYZd{}).u) && std::isnan(uv_1960_of(XYZd{}).v));
    EXPECT_FALSE(std::isfinite(chromaticity_of(XYZd{1.0, 1.0, -2.0}).x)) << "another sum of 0";
}

TEST(XyzOfChromaticity, ScalesWithTheLuminance) {
    const Chromaticity xy = {0.25, 0.5};
    EXPECT_EQ(xyz_of(xy), (XYZd{0.5, 1.0, 0.5}));
    EXPECT_EQ(xyz_of(xy, 80.0), (XYZd{40.0, 80.0, 40.0}));
    EXPECT_EQ(xyz_of(xy, 0.0), XYZd{});
}

TEST(XyzOfChromaticity, RefusesLightsWithoutLuminance) {
    EXPECT_THAT([] { (void)xyz_of({0.3, 0.0}); }, ThrowsMessage<std::invalid_argument>(HasSubstr("(0.3, 0)")));
    EXPECT_THROW((void)xyz_of(chromaticity_of(XYZd{})), std::invalid_argument);
    EXPECT_THAT(
        [] {
            (void)xyz_of({0.3, 0.3}, std::numeric_limits<double>::infinity());
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("luminance = inf")));
}

}  // namespace
}  // namespace emulsion
