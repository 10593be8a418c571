#include "display/display_rgb.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"

namespace emulsion {
namespace {

/// The defaults, and one in a lit room.
std::vector<Display> all_displays() {
    std::vector<Display> all;
    for_each_alternative<Display>([&](const auto& display) { all.emplace_back(display); });
    all.emplace_back(SrgbDisplay{10.0, 5.0, 1000.0});
    return all;
}

// The matrix of IEC 61966-2-1 as printed, to its four digits.
TEST(DisplayRgb, SrgbMatrixIsTheStandards) {
    constexpr std::array<std::array<double, 3>, 3> kPrinted = {
        {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}};
    const Matrix3 matrix = rgb_from_xyz(SrgbDisplay{}).matrix;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            // The standard inverted a matrix that it had rounded to four digits.
            EXPECT_NEAR(matrix.m[row][column], kPrinted[row][column], 5e-4) << row << ", " << column;
        }
    }
}

TEST(DisplayRgb, WhiteIsOneOneOne) {
    for_each_alternative<Display>([](const auto& chosen) {
        const Display display = chosen;
        const XYZd white = white_xyz(display);
        EXPECT_EQ(white.y, 1.0);
        const RGBd rgb = display_rgb(rgb_from_xyz(display), white);
        EXPECT_NEAR(rgb.r, 1.0, 1e-14);
        EXPECT_NEAR(rgb.g, 1.0, 1e-14);
        EXPECT_NEAR(rgb.b, 1.0, 1e-14);
    });
}

TEST(DisplayRgb, SinglePrecisionIsWithinItsTolerance) {
    for (Display display : all_displays()) {
        const RgbFromXyz conversion = rgb_from_xyz(display);
        const double gain = signal_scale(light_of(display)).gain;
        Pcg32 random(30);
        std::vector<XYZ> xyz(20000);
        for (XYZ& p : xyz) {
            const float size = std::pow(10.0f, 20.0f * random.next_float() - 10.0f);
            p = size * XYZ{random.next_float() - 0.1f, random.next_float(), random.next_float() - 0.1f};
        }
        std::vector<RGB> rgb(xyz.size());
        display_rgb(conversion, xyz, rgb);
        for (std::size_t i = 0; i < xyz.size(); ++i) {
            const XYZd p{xyz[i].x, xyz[i].y, xyz[i].z};
            const RGBd exact = display_rgb(conversion, p);
            const double tolerance =
                1e-6 * gain * (std::abs(p.x) + std::abs(p.y) + std::abs(p.z)) + 1e-7 * conversion.pedestal;
            ASSERT_NEAR(rgb[i].r, exact.r, tolerance) << to_text(display);
            ASSERT_NEAR(rgb[i].g, exact.g, tolerance) << to_text(display);
            ASSERT_NEAR(rgb[i].b, exact.b, tolerance) << to_text(display);
        }
    }
}

// The signal makes luminances, with black and flare on top, proportional to what was wanted.
TEST(DisplayRgb, BlackAndFlareAreTakenOffTheSignal) {
    const SrgbDisplay lit{100.0, 0.5, 4.0};
    const RgbFromXyz conversion = rgb_from_xyz(lit);
    for (const double wanted : {0.0, 0.01, 0.18, 0.5, 1.0}) {
        const RGBd signal = display_rgb(conversion, wanted * white_xyz(lit));
        const double seen_cdm2 = signal.g * (100.0 - 0.5) + 0.5 + 4.0;
        EXPECT_NEAR(seen_cdm2, wanted * 104.0, 1e-12) << wanted;
        EXPECT_NEAR(signal.r, signal.g, 1e-14);
        EXPECT_NEAR(signal.b, signal.g, 1e-14);
    }
    EXPECT_LT(display_rgb(conversion, 0.04 * white_xyz(lit)).g, 0.0);
    EXPECT_GT(display_rgb(conversion, 0.044 * white_xyz(lit)).g, 0.0);
}

TEST(DisplayRgb, NeitherBlackNorFlareChangesNothing) {
    for_each_alternative<Display>([](const auto& chosen) {
        EXPECT_EQ(rgb_from_xyz(chosen), (RgbFromXyz{rgb_from_xyz(rgb_space(Display(chosen))), 0.0}));
    });
}

TEST(DisplayRgb, TheSceneWhiteBecomesWhiteByEveryMethod) {
    constexpr Chromaticity kTungsten{0.44758, 0.40745};
    for_each_alternative<SceneWhite>([&]<class T>(T white) {
        if constexpr (!std::is_empty_v<T>) white = {kTungsten.x, kTungsten.y};
        for_each_alternative<Display>([&](const auto& display) {
            const XYZd shown = shown_as_white(white, display);
            EXPECT_EQ(shown, std::is_empty_v<T> ? white_xyz(display) : xyz_of(kTungsten));
            const RGBd rgb = display_rgb(rgb_from_xyz(display, white), shown);
            EXPECT_NEAR(rgb.r, 1.0, 1e-13);
            EXPECT_NEAR(rgb.g, 1.0, 1e-13);
            EXPECT_NEAR(rgb.b, 1.0, 1e-13);
        });
    });
}

// Lindbloom's matrix for Bradford from D50 to D65, http://www.brucelindbloom.com/Eqn_ChromAdapt.html, of whites of ASTM
// E308 that differ from (0.3457, 0.3585) and (0.3127, 0.329) in the fifth digit.
TEST(DisplayRgb, BradfordIsThePublishedMatrix) {
    constexpr std::array<std::array<double, 3>, 3> kPrinted = {
        {{0.9555766, -0.0230393, 0.0631636}, {-0.0282895, 1.0099416, 0.0210077}, {0.0122982, -0.0204830, 1.3299098}}};
    const Matrix3 matrix = display_from_scene(AdaptedBy<BradfordAdaptation>{0.3457, 0.3585}, SrgbDisplay{});
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            EXPECT_NEAR(matrix.m[row][column], kPrinted[row][column], 1e-3) << row << ", " << column;
        }
    }
}

TEST(DisplayRgb, EqualWhitesAdaptToTheSameMatrix) {
    EXPECT_EQ(rgb_from_xyz(SrgbDisplay{}, AdaptedBy<BradfordAdaptation>{}), rgb_from_xyz(SrgbDisplay{}));
    EXPECT_NE(rgb_from_xyz(DciP3Display{}, AdaptedBy<BradfordAdaptation>{}), rgb_from_xyz(DciP3Display{}));
}

TEST(DisplayRgb, LargeStaysFiniteAndNanStaysAlone) {
    const std::vector<XYZ> xyz{{0x1p119f, 0x1p119f, 0x1p119f},
                               {std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f},
                               {0x1p119f, -0x1p119f, -0x1p119f}};
    std::vector<RGB> rgb(3);
    display_rgb(rgb_from_xyz(Display{}), xyz, rgb);
    for (const std::size_t i : {0, 2}) {
        EXPECT_TRUE(std::isfinite(rgb[i].r) && std::isfinite(rgb[i].g) && std::isfinite(rgb[i].b));
    }
    EXPECT_TRUE(std::isnan(rgb[1].r));
}

}  // namespace
}  // namespace emulsion
