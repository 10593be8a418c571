#include "tonemap/zone.h"

#include <cmath>

#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"

namespace emulsion {
namespace {

// Of grey 10 on zone V, 55 is 0.99 of white.
TEST(ZoneSystem, RangeThatFitsIsExactlyLinear) {
    const PreparedOperator displayed(ZoneSystem{10.0f}, row_of_greys({0.001f, 55.0f}), 3.0);
    EXPECT_FALSE(displayed.reproduction.compression);
    EXPECT_DOUBLE_EQ(displayed(10.0), 0.18);
    EXPECT_DOUBLE_EQ(displayed(55.0), 0.99);
    EXPECT_DOUBLE_EQ(displayed(0.001), 1.8e-5);
}

TEST(ZoneSystem, GreyIsPlacedOnItsZone) {
    for (const float most : {20.0f, 1e3f, 1e9f}) {
        for (int zone = 0; zone <= 7; ++zone) {
            const PreparedOperator displayed(ZoneSystem{10.0f, static_cast<float>(zone)}, row_of_greys({1.0f, most}),
                                             3.0);
            EXPECT_NEAR(displayed(10.0), 0.18 * std::pow(2.0, zone - 5), 1e-15) << zone << ", " << most;
        }
    }
    EXPECT_DOUBLE_EQ(PreparedOperator(ZoneSystem{}, row_of_greys({1.0f, 1e3f}), 3.0)(3.0), 0.18);
}

// Grey 1 on V and 100 at most: Lmax = 18, w = 17.82/0.82 = 21.73171. Of Y = 1/0.18, L = 1 and t = 1.
TEST(ZoneSystem, RangeThatDoesNotFitHasAShoulder) {
    const PreparedOperator displayed(ZoneSystem{1.0f}, row_of_greys({0.01f, 100.0f}), 1.0);
    EXPECT_DOUBLE_EQ(displayed(0.01), 0.0018);
    EXPECT_NEAR(displayed(1.0 / 0.18), 0.18 + 0.82 * (1.0 + 1.0 / (21.7317073 * 21.7317073)) / 2.0, 1e-9);
    EXPECT_NEAR(displayed(100.0), 1.0, 1e-14);
    EXPECT_GT(displayed(110.0), 1.0);
}

TEST(ZoneSystem, ShoulderBeginsWithTheSlopeOfTheStraightPart) {
    for (const float most : {10.0f, 1e2f, 1e6f, 1e30f}) {
        const PreparedOperator displayed(ZoneSystem{1.0f}, row_of_greys({0.01f, most}), 1.0);
        EXPECT_NEAR(displayed.slope(1.0 - 1e-4), 0.18, 1e-9);
        EXPECT_NEAR(displayed.slope(1.0 + 1e-4), 0.18, 2e-4 * 0.18) << most;  // 2 t, t = 0.18e-4/0.82
        EXPECT_NEAR(displayed(1.0 + 1e-9), displayed(1.0 - 1e-9), 1e-9);
    }
}

TEST(ZoneSystem, ShoulderVanishesAsTheRangeComesToFit) {
    const float white = 1.0f / 0.18f;
    const PreparedOperator displayed(ZoneSystem{1.0f}, row_of_greys({0.01f, white * (1.0f + 1e-5f)}), 1.0);
    ASSERT_TRUE(displayed.reproduction.compression);
    for (double luminance = 0.1; luminance < white; luminance *= 1.1) {
        EXPECT_NEAR(displayed(luminance), 0.18 * luminance, 2e-5);
    }
}

TEST(ZoneSystem, AreaOfThePictureCanBeTheGrey) {
    Image<XYZ> scene(10, 10);
    for (XYZ& pixel : scene.pixels()) pixel = grey(500.0f);
    for (int y = 5; y < 10; ++y) {
        for (int x = 5; x < 10; ++x) scene(x, y) = grey(7.0f);
    }
    const ToneMapping mapping{ZoneSystem{0.0f, 6.0f}, SpotAdaptation{0.75f, 0.75f, 0.1f}};
    const Image<XYZ> mapped = tone_map(mapping, scene.view(), {0.95f, 1.0f, 1.09f}, 1).image;
    EXPECT_NEAR(mapped(7, 7).y, 0.36f, 0.36f * 1e-4f);
    EXPECT_NEAR(mapped(0, 0).y, 1.0f, 0.031f);  // 500 is the robust maximum to the width of a bin
}

TEST(ZoneSystem, DynamicRangeIsInStops) {
    const auto zones = [](const Image<XYZ>& scene) { return dynamic_range_zones(SceneLuminance(scene.view(), 1)); };
    EXPECT_DOUBLE_EQ(zones(row_of_greys({1.0f, 0.0f, 1024.0f})), 10.0);
    EXPECT_EQ(zones(row_of_greys({5.0f, 5.0f})), 0.0);
    EXPECT_EQ(zones(row_of_greys({0.0f})), 0.0);
    Image<XYZ> outlier = ramp_of_greys(1.0, 1024.0, 2000);
    outlier(7, 0) = grey(1e30f);
    EXPECT_NEAR(zones(outlier), 10.0, 0.1);
}

}  // namespace
}  // namespace emulsion
