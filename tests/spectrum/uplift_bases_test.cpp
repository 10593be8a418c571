// What Smits's boxes, the Mallett-Yuksel basis and the three bands have of their own.

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/uplift_basis.h"
#include "spectrum/uplift_smits.h"
#include "spectrum/uplift_three_bands.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(PrimaryBasis, AddsUpToOneAndIsLinearInRgb) {
    const PrimaryBasis basis(reflectance_rgb(rgb_space("sRGB")));
    const auto red = basis.reflectance({1, 0, 0}), green = basis.reflectance({0, 1, 0}),
               blue = basis.reflectance({0, 0, 1}), mixed = basis.reflectance({0.3, 0.7, 0.2});
    for (std::size_t i = 0; i < red.value.size(); ++i) {
        EXPECT_NEAR(red.value[i] + green.value[i] + blue.value[i], 1.0, 1e-15);
        EXPECT_NEAR(0.3 * red.value[i] + 0.7 * green.value[i] + 0.2 * blue.value[i], mixed.value[i], 1e-15);
    }
}

// Where two spectra cross, by bisection between two wavelengths.
double crossing_nm(const Spectrum& falling, const Spectrum& rising, double low_nm, double high_nm) {
    for (int i = 0; i < 40; ++i) {
        const double middle_nm = 0.5 * (low_nm + high_nm);
        (eval(falling, middle_nm) > eval(rising, middle_nm) ? low_nm : high_nm) = middle_nm;
    }
    return low_nm;
}

TEST(PrimaryBasis, HasTheBandsOfThePublishedOne) {
    // Mallett & Yuksel tabulate blue 0.609, 0.115 and green 0.380, 0.876 at 490 and 500 nm: they cross at 492.3 nm;
    // green 0.955, 0.364 and red 0.032, 0.624 at 580 and 590 nm: at 587.8 nm. With gentler edges ours are near.
    const PrimaryBasis basis(reflectance_rgb(rgb_space("sRGB")));
    const auto red = basis.reflectance({1, 0, 0}), green = basis.reflectance({0, 1, 0}),
               blue = basis.reflectance({0, 0, 1});
    EXPECT_NEAR(crossing_nm(blue, green, 460.0, 530.0), 492.3, 3.0);
    EXPECT_NEAR(crossing_nm(green, red, 550.0, 630.0), 587.8, 3.0);
}

TEST(PrimaryBasis, NeedsASpaceWithoutMoreSaturatedPrimaries) {
    // The authors found one for PAL/SECAM only, of the spaces that they tried besides sRGB.
    for (const char* name : {"Display_P3", "Rec2020", "Adobe_RGB_1998"}) {
        EXPECT_THAT([&] { PrimaryBasis basis(reflectance_rgb(rgb_space(name))); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr("mallett-yuksel")))
            << name;
    }
    EXPECT_NO_THROW(PrimaryBasis(reflectance_rgb(rgb_space("PAL_SECAM"))));
}

TEST(SmitsBasis, IsTenBoxes) {
    const SmitsBasis basis(reflectance_rgb(rgb_space("sRGB")));
    const auto orange = basis.reflectance({0.9, 0.5, 0.1});
    EXPECT_EQ(eval(orange, 360.0), eval(orange, 414.0));
    EXPECT_NE(eval(orange, 414.0), eval(orange, 415.0));
    EXPECT_EQ(eval(orange, 415.0), eval(orange, 448.0));
    EXPECT_EQ(eval(orange, 687.0), eval(orange, 830.0));
}

TEST(SmitsBasis, IsWhitePlusASecondaryPlusAPrimary) {
    const SmitsBasis basis(reflectance_rgb(rgb_space("sRGB")));
    const auto yellow = basis.reflectance({1, 1, 0}), red = basis.reflectance({1, 0, 0}),
               orange = basis.reflectance({0.9, 0.5, 0.1});
    for (std::size_t i = 0; i < red.value.size(); ++i) {
        EXPECT_NEAR(orange.value[i], 0.1 + 0.4 * yellow.value[i] + 0.4 * red.value[i], 1e-15);
    }
}

TEST(ThreeBands, NeedNoClippingInSrgb) {
    // Found by the search over all edges, and so written down here: the edges, and that even the corners fit.
    const ReflectanceRgb space = reflectance_rgb(rgb_space("sRGB"));
    const ThreeBands bands(space);
    EXPECT_EQ(bands.edge_nm(), (std::array<int, 2>{489, 586}));
    for (const RGBd& rgb : {RGBd{1, 0, 0}, RGBd{0, 1, 0}, RGBd{0, 0, 1}, RGBd{0, 1, 1}, RGBd{1, 0, 1}, RGBd{1, 1, 0}}) {
        for (const double value : bands.unclipped(rgb)) EXPECT_TRUE(value >= 0.0 && value <= 1.0) << value;
    }
}

TEST(ThreeBands, ClipWhatNoBandsReach) {
    const ReflectanceRgb space = reflectance_rgb(rgb_space("Rec2020"));
    const ThreeBands bands(space);
    const std::array<double, 3> green = bands.unclipped({0, 1, 0});
    EXPECT_LT(*std::min_element(green.begin(), green.end()), -0.05);
    EXPECT_EQ(bands.reflectance({0, 1, 0}).value.front(), 0.0);
    // Muted colours are exact.
    const RGBd muted = {0.4, 0.6, 0.5};
    const auto rgb = weighted_sums(space.rgb_weights, bands.reflectance(muted));
    EXPECT_NEAR(rgb[0], muted.r, 1e-14);
    EXPECT_NEAR(rgb[1], muted.g, 1e-14);
    EXPECT_NEAR(rgb[2], muted.b, 1e-14);
}

}  // namespace
}  // namespace emulsion
