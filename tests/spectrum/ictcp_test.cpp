#include "spectrum/ictcp.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/random.h"
#include "spectrum/itp_difference.h"
#include "spectrum/pq.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

XYZd xyz_of_rec2020(const std::array<double, 3>& rgb_cdm2) {
    const auto xyz = xyz_from_rgb(rgb_space("Rec2020")) * rgb_cdm2;
    return {xyz[0], xyz[1], xyz[2]};
}

TEST(ICtCp, GreysOfD65HaveNoChroma) {
    const XYZd white = xyz_of(rgb_space("Rec2020").white);
    for (const double luminance_cdm2 : {0.005, 1.0, 100.0, kIctcpReferenceWhite_cdm2, 10000.0}) {
        const ICtCp grey = ictcp_from_xyz(luminance_cdm2 * white);
        EXPECT_NEAR(grey.i, encode(PqTransfer{}, luminance_cdm2 / 10000.0), 1e-14);
        EXPECT_NEAR(grey.ct, 0.0, 1e-14);
        EXPECT_NEAR(grey.cp, 0.0, 1e-14);
    }
    EXPECT_NEAR(ictcp_from_xyz(10000.0 * white).i, 1.0, 1e-14);
    const ICtCp black = ictcp_from_xyz({});
    EXPECT_NEAR(black.i, 7.30955902578e-7, 1e-17);
    EXPECT_NEAR(black.ct, 0.0, 1e-20);
    EXPECT_NEAR(black.cp, 0.0, 1e-20);
}

// The example of colour-science's RGB_to_ICtCp: BT.2020 in cd/m^2. Its values are cut off after 7 decimals.
TEST(ICtCp, HasThePublishedExample) {
    const ICtCp ictcp = ictcp_from_xyz(xyz_of_rec2020({0.45620519, 0.03081071, 0.04091952}));
    EXPECT_NEAR(ictcp.i, 0.0735136, 1e-7);
    EXPECT_NEAR(ictcp.ct, 0.0047525, 1e-7);
    EXPECT_NEAR(ictcp.cp, 0.0935159, 1e-7);
}

// By the standard's integers alone, for red of 10000 cd/m^2.
TEST(ICtCp, OfPeakRed) {
    const double l = encode(PqTransfer{}, 1688.0 / 4096.0), m = encode(PqTransfer{}, 683.0 / 4096.0),
                 s = encode(PqTransfer{}, 99.0 / 4096.0);
    const ICtCp red = ictcp_from_xyz(xyz_of_rec2020({10000.0, 0.0, 0.0}));
    EXPECT_NEAR(red.i, 0.5 * (l + m), 1e-14);
    EXPECT_NEAR(red.ct, (6610.0 * l - 13613.0 * m + 7003.0 * s) / 4096.0, 1e-13);
    EXPECT_NEAR(red.cp, (17933.0 * l - 17390.0 * m - 543.0 * s) / 4096.0, 1e-13);
}

TEST(ICtCp, ColoursOfBt2020LieWithinHalf) {
    for (int corner = 0; corner < 8; ++corner) {
        for (const double peak_cdm2 : {1.0, 203.0, 1000.0, 10000.0}) {
            const ICtCp ictcp =
                ictcp_from_xyz(xyz_of_rec2020({(corner & 1) != 0 ? peak_cdm2 : 0.0, (corner & 2) != 0 ? peak_cdm2 : 0.0,
                                               (corner & 4) != 0 ? peak_cdm2 : 0.0}));
            EXPECT_LE(std::abs(ictcp.ct), 0.5 + 1e-12) << corner;
            EXPECT_LE(std::abs(ictcp.cp), 0.5 + 1e-12) << corner;
        }
    }
}

// Colours in and far outside BT.2020, some with negative LMS, and above 10000 cd/m^2.
TEST(ICtCp, RoundTripIsExact) {
    Pcg32 random(90);
    const auto unit = [&] { return static_cast<double>(random.next_float()); };
    for (int i = 0; i < 5000; ++i) {
        const double scale = std::pow(10.0, 7.0 * unit() - 3.0);  // 0.001 to 10000 cd/m^2
        const XYZd xyz = {scale * (2.0 * unit() - 0.5), scale * (2.0 * unit() - 0.5), scale * (2.0 * unit() - 0.5)};
        const XYZd back = xyz_from_ictcp(ictcp_from_xyz(xyz));
        ASSERT_NEAR(back.x, xyz.x, 1e-10 * scale);
        ASSERT_NEAR(back.y, xyz.y, 1e-10 * scale);
        ASSERT_NEAR(back.z, xyz.z, 1e-10 * scale);
    }
    const XYZd black = xyz_from_ictcp(ictcp_from_xyz({}));
    EXPECT_NEAR(black.y, 0.0, 1e-15);
}

TEST(ICtCp, NaNStaysNaN) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(ictcp_from_xyz({nan, 1.0, 1.0}).i));
    EXPECT_TRUE(std::isnan(xyz_from_ictcp({0.5, nan, 0.0}).y));
}

// Values of colour-science's tests of delta_E_ITP. The colours are printed to 1e-10, which is 720 times that here.
TEST(ItpDifference, HasThePublishedValues) {
    const auto itp = [](const ICtCp& a, const ICtCp& b) { return difference(ItpDifference{}, a, b); };
    EXPECT_NEAR(itp({0.4885468072, -0.04739350675, 0.07475401302}, {0.4899203231, -0.04567508203, 0.07361341775}),
                1.426572247, 7.2e-8);
    EXPECT_NEAR(itp({0.5965650331, -0.2083210482, 0.3699729716}, {0.596263079, -0.1629742033, 0.3617767026}),
                17.36012552, 7.2e-8);
    EXPECT_NEAR(itp({0.7055787513, -0.4063731514, -0.07278767382}, {0.7046946082, -0.3771037586, -0.07141626753}),
                10.60227327, 7.2e-8);
}

TEST(ItpDifference, HalvesCtAndIsSymmetric) {
    const ICtCp a = {0.5, 0.1, -0.1}, b = {0.5, 0.3, -0.1}, c = {0.5, 0.1, 0.1};
    EXPECT_DOUBLE_EQ(difference(ItpDifference{}, a, b), 72.0);
    EXPECT_DOUBLE_EQ(difference(ItpDifference{}, a, c), 144.0);
    EXPECT_EQ(difference(ItpDifference{}, b, c), difference(ItpDifference{}, c, b));
    EXPECT_EQ(difference(ItpDifference{}, a, a), 0.0);
    EXPECT_TRUE(std::isnan(difference(ItpDifference{}, a, {0.5, std::numeric_limits<double>::quiet_NaN(), 0.0})));
}

}  // namespace
}  // namespace emulsion
