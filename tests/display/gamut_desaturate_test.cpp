#include "display/gamut_desaturate.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "display/gamut_mapper.h"
#include "gamut_fixture.h"
#include "spectrum/gamut.h"

namespace emulsion {
namespace {

TEST(GamutDesaturate, KeepsLuminanceAndStopsAtTheBoundary) {
    for (const DisplayGamut& gamut : all_gamuts()) {
        const auto luminance = [&](const RGBd& c) {
            return gamut.luminance.r * c.r + gamut.luminance.g * c.g + gamut.luminance.b * c.b;
        };
        for (const RGB& color : colours_about_the_gamut(45, 3000)) {
            const RGBd before = wide(color), after = map_gamut(GamutDesaturate{}, gamut, before);
            if (gamut_margin(before) >= 0.0) continue;
            EXPECT_NEAR(luminance(after), std::clamp(luminance(before), 0.0, 1.0), 1e-14);
            EXPECT_NEAR(gamut_margin(after), 0.0, 1e-15);
        }
    }
}

// Luminance of the light that is shown is as affine in the signal as each component of that light: what keeps one keeps
// the other.
TEST(GamutDesaturate, KeepsTheLuminanceThatIsShownOnADisplayWithFlare) {
    const SrgbDisplay display{80.0, 0.5, 5.0};
    const DisplayGamut gamut = display_gamut(display);
    const auto shown_cdm2 = [&](const RGBd& signal) {
        const auto cdm2 = [&](double s) { return s * (80.0 - 0.5) + 0.5 + 5.0; };
        return gamut.luminance.r * cdm2(signal.r) + gamut.luminance.g * cdm2(signal.g) +
               gamut.luminance.b * cdm2(signal.b);
    };
    for (const RGB& color : colours_about_the_gamut(48, 3000)) {
        const double wanted = std::clamp(shown_cdm2(wide(color)), 5.5, 85.0);
        EXPECT_NEAR(shown_cdm2(map_gamut(GamutDesaturate{}, gamut, wide(color))), wanted, 1e-11);
    }
}

TEST(GamutDesaturate, ByHand) {
    // Luminances of sRGB's primaries: 0.2126, 0.7152, 0.0722. Y = 0.5 (to 4 digits), t = 0.5 / 1.5 down to red 0 or so.
    const DisplayGamut even{{0.25, 0.5, 0.25}, {}, {}};
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{-0.5, 0.75, 1.0}), (RGBd{0.0, 0.625, 0.75}));
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{1.5, 0.25, 0.0}), (RGBd{1.0, 0.375, 0.25}));
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{4.0, 0.0, 0.5}), (RGBd{1.0, 1.0, 1.0}));
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{-4.0, 0.0, 0.5}), (RGBd{0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace emulsion
