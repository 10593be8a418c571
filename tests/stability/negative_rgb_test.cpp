// Colours that no RGB of real primaries has: negative components, and where they are clipped.

#include <algorithm>

#include <gtest/gtest.h>

#include "colour_math.h"
#include "display/gamut_mapper.h"
#include "spectrum/observer.h"
#include "spectrum/rgb_space.h"

namespace emulsion::stability {
namespace {

TEST(NegativeRgb, OfEveryMonochromaticLight) {
    int inside_rec709 = 0, inside_rec2020 = 0;
    for (int nm = 400; nm <= 700; ++nm) {
        const XYZd xyz = eval(cie_1931_2deg(), nm);
        const auto is_inside = [&xyz](const char* space) {
            const RGBd rgb = rgb_by(rgb_from_xyz(rgb_space(space)), xyz);
            return std::min({rgb.r, rgb.g, rgb.b}) >= 0.0;
        };
        inside_rec709 += is_inside("Rec709") ? 1 : 0;
        inside_rec2020 += is_inside("Rec2020") ? 1 : 0;
    }
    EXPECT_EQ(inside_rec709, 0);
    // Those of its primaries, of which two are whole nanometres.
    EXPECT_EQ(inside_rec2020, 2);
}

/// Paths of one wavelength each, evenly over the spectrum of equal energy: their mean is a white. Kept in RGB, with
/// what is below 0 clipped away path by path, it is not.
TEST(NegativeRgb, ClippedBeforeTheSumIsAnotherColour) {
    const Matrix3 rgb_of = rgb_from_xyz(rgb_space("Rec709")), xyz_of = xyz_from_rgb(rgb_space("Rec709"));
    RGBd clipped;
    XYZd sum;
    for (int nm = 360; nm <= 830; ++nm) {
        const XYZd xyz = eval(cie_1931_2deg(), nm);
        const RGBd rgb = rgb_by(rgb_of, xyz);
        clipped = clipped + RGBd{std::max(rgb.r, 0.0), std::max(rgb.g, 0.0), std::max(rgb.b, 0.0)};
        sum = sum + xyz;
    }
    const XYZd naive = xyz_by(xyz_of, clipped), white = 1.0 / sum.y * sum;
    EXPECT_NEAR(naive.y / sum.y, 1.195, 0.001);
    EXPECT_NEAR(ciede2000(0.5 * white, 0.5 / sum.y * naive, white), 9.04, 0.05);
    // A film of X, Y and Z has nothing below 0 to clip.
    for (int nm = 360; nm <= 830; ++nm) {
        const XYZd xyz = eval(cie_1931_2deg(), nm);
        EXPECT_GE(std::min({xyz.x, xyz.y, xyz.z}), 0.0) << nm;
    }
}

/// Light of 520 nm at a fifth of white, shown by Rec. 709.
TEST(NegativeRgb, ClippedOnTheDisplayChangesLuminance) {
    const DisplayGamut display = display_gamut(SrgbDisplay{});
    const XYZd locus = eval(cie_1931_2deg(), 520.0);
    const RGBd rgb = rgb_by(rgb_from_xyz(rgb_space("sRGB")), 0.2 / locus.y * locus);
    EXPECT_NEAR(rgb.r, -0.261, 0.001);
    const auto luminance = [&](const GamutMapper& mapper) {
        const RGBd shown = map_gamut(mapper, display, rgb);
        return xyz_by(xyz_from_rgb(rgb_space("sRGB")), shown).y;
    };
    EXPECT_NEAR(luminance(GamutClip{}) / 0.2, 1.283, 0.001);
    EXPECT_NEAR(luminance(GamutDesaturate{}) / 0.2, 1.0, 1e-6);
}

}  // namespace
}  // namespace emulsion::stability
