#include "display/gamut_oklab.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "display/display_rgb.h"
#include "display/gamut_mapper.h"
#include "gamut_fixture.h"
#include "spectrum/gamut.h"
#include "spectrum/observer.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {
namespace {

// As display/gamut_oklab.h says: 4 degrees, 0.01 of lightness. Of colours with any chroma to speak of, and no more
// than in sight: those at the ends of lightness become black and white.
TEST(GamutOklab, KeepsLightnessAndHueOfTheLightShownAndStopsAtTheBoundary) {
    for (const DisplayGamut& gamut : all_gamuts()) {
        const double black = oklab_of(gamut, {}).l;
        double worst_deg = 0.0;
        for (const RGB& color : colours_about_the_gamut(46, 3000)) {
            const RGBd after = map_gamut(GamutOklab{}, gamut, wide(color));
            if (gamut_margin(wide(color)) >= 0.0) continue;
            const Oklab wanted = oklab_of(gamut, wide(color)), found = oklab_of(gamut, after);
            EXPECT_NEAR(gamut_margin(after), 0.0, 1e-14);
            EXPECT_NEAR(found.l, std::clamp(wanted.l, black, 1.0), 0.01);
            const double kept = std::hypot(found.a, found.b);
            EXPECT_LT(kept, std::hypot(wanted.a, wanted.b) + 0.01);
            if (kept > 0.02) worst_deg = std::max(worst_deg, hue_difference_deg(found, wanted));
        }
        EXPECT_LT(worst_deg, 4.0);
    }
}

// Colours measured on a display in a lit room: with the signal taken for light, their hue was 30 degrees off and more.
TEST(GamutOklab, KeepsTheHueThatIsSeenInALitRoom) {
    const SrgbDisplay display{80.0, 0.0, 5.0};
    const DisplayGamut gamut = display_gamut(display);
    for (const RGBd& light : {RGBd{0.31, 0.0515, 0.0167}, {0.2, 0.05, 0.05}, {0.05, 0.055, 0.3}, {0.02, 0.3, 0.03}}) {
        // Relative to the white as it is seen, 85 cd/m^2.
        const auto signal = [](double v) { return (v * 85.0 - 5.0) / 80.0; };
        const auto cdm2 = [](double s) { return 80.0 * s + 5.0; };
        const RGBd mapped = map_gamut(GamutOklab{}, gamut, RGBd{signal(light.r), signal(light.g), signal(light.b)});
        const DisplayGamut plain = display_gamut(SrgbDisplay{});
        const Oklab shown = oklab_of(plain, 1.0 / 85.0 * RGBd{cdm2(mapped.r), cdm2(mapped.g), cdm2(mapped.b)});
        EXPECT_LT(hue_difference_deg(shown, oklab_of(plain, light)), 4.0) << light.r;
        EXPECT_NEAR(shown.l, oklab_of(plain, light).l, 0.01) << light.r;
    }
}

// The spectrum from violet to blue-green, where it passes the blue corners: of the three brightnesses the steps of
// 0.1 nm are no larger than these in 8-bit codes of sRGB, and ten times finer ones a fraction of it.
TEST(GamutOklab, MonochromaticLightChangesSteadily) {
    const auto largest_step = [](const Display& display, double step_nm) {
        const DisplayGamut gamut = display_gamut(display);
        const RgbFromXyz conversion = rgb_from_xyz(display);
        double largest = 0.0;
        for (const double brightness : {0.05, 0.45, 1.0}) {
            std::optional<RGBd> last;
            for (int i = 0; i * step_nm <= 60.0; ++i) {
                const XYZd xyz = brightness * eval(cie_1931_2deg(), 440.0 + i * step_nm);
                const RGBd mapped = map_gamut(GamutOklab{}, gamut, display_rgb(conversion, xyz));
                const auto code = [](double v) { return 255.0 * encode(SrgbTransfer{}, v); };
                const RGBd codes{code(mapped.r), code(mapped.g), code(mapped.b)};
                if (last) largest = std::max(largest, distance(codes, *last));
                last = codes;
            }
        }
        return largest;
    };
    for (const Display& display : all_displays()) {
        const double coarse = largest_step(display, 0.1), fine = largest_step(display, 0.01);
        EXPECT_LT(coarse, 20.0) << to_text(display);
        EXPECT_LT(fine, 6.0) << to_text(display);
    }
}

// Of one lightness and hue, all colours outside go to about the same place, and those inside stay: chroma out hardly
// falls. Of what light there may be: no more chroma than 1.2 times the lightness.
TEST(GamutOklab, ChromaHardlyFalls) {
    Pcg32 random(47);
    for (const DisplayGamut& gamut : all_gamuts()) {
        const Matrix3 oklab_from_roots = kOklabFromRoots, roots_from_oklab = inverse(oklab_from_roots);
        for (int i = 0; i < 300; ++i) {
            const double lightness = 0.02 + 0.96 * random.next_float(), hue = 6.2832 * random.next_float();
            double last = 0.0;
            for (double chroma = 0.01; chroma < std::min(0.35, 1.2 * lightness); chroma += 0.01) {
                auto cones = roots_from_oklab * std::array{lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
                for (double& cone : cones) cone *= cone * cone;
                const auto rgb = gamut.rgb_from_cones * cones;
                const Oklab found = oklab_of(gamut, map_gamut(GamutOklab{}, gamut, RGBd{rgb[0], rgb[1], rgb[2]}));
                EXPECT_GE(std::hypot(found.a, found.b), last - 0.02) << lightness << ' ' << hue << ' ' << chroma;
                last = std::max(last, std::hypot(found.a, found.b));
            }
        }
    }
}

// Ottosson's example of a blue that clipping turns purple: the brightest blue of BT.2020 on sRGB.
TEST(GamutOklab, KeepsTheHueThatClippingLoses) {
    const DisplayGamut gamut = display_gamut(SrgbDisplay{});
    const auto rgb = rgb_from_rgb(rgb_space("Rec2020"), rgb_space("sRGB")) * std::array{0.0, 0.0, 1.0};
    const RGBd blue{rgb[0], rgb[1], rgb[2]};
    const auto hue_deg = [&](const RGBd& c) { return oklch_from_oklab(oklab_of(gamut, c)).hue_deg; };
    EXPECT_NEAR(hue_deg(map_gamut(GamutOklab{}, gamut, blue)), hue_deg(blue), 4.0);
    EXPECT_GT(std::abs(hue_deg(map_gamut(GamutClip{}, gamut, blue)) - hue_deg(blue)), 12.0);
}

}  // namespace
}  // namespace emulsion
