#include "display/gamut_mapper.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"
#include "display/display_rgb.h"
#include "spectrum/gamut.h"
#include "spectrum/observer.h"
#include "spectrum/oklab.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

bool same_bits(const RGB& a, const RGB& b) {
    return std::bit_cast<std::uint32_t>(a.r) == std::bit_cast<std::uint32_t>(b.r) &&
           std::bit_cast<std::uint32_t>(a.g) == std::bit_cast<std::uint32_t>(b.g) &&
           std::bit_cast<std::uint32_t>(a.b) == std::bit_cast<std::uint32_t>(b.b);
}

RGBd wide(const RGB& rgb) { return {rgb.r, rgb.g, rgb.b}; }

double distance(const RGBd& a, const RGBd& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// The defaults, and with a black of their own, in lit rooms.
std::vector<Display> all_displays() {
    std::vector<Display> all;
    for_each_alternative<Display>([&](const auto& display) {
        all.emplace_back(display);
        auto lit = display;
        lit.black_cdm2 = 0.5, lit.flare_cdm2 = 5.0;
        all.emplace_back(lit);
    });
    return all;
}

std::vector<DisplayGamut> all_gamuts() {
    std::vector<DisplayGamut> all;
    for (const Display& display : all_displays()) all.push_back(display_gamut(display));
    return all;
}

/// Linear RGB, some in the gamut, more around it, a few far out.
std::vector<RGB> colours_about_the_gamut(unsigned seed, int count) {
    Pcg32 random(seed);
    std::vector<RGB> colours;
    for (int i = 0; i < count; ++i) {
        const float size = i % 10 == 0 ? 100.0f : 1.0f;
        const auto component = [&] { return size * (1.6f * random.next_float() - 0.3f); };
        colours.push_back({component(), component(), component()});
    }
    return colours;
}

/// Of the light that is shown for a signal, with the display's white as Oklab's own.
Oklab oklab_of(const DisplayGamut& gamut, const RGBd& signal) {
    const auto cones = gamut.cones_from_rgb *
                       std::array{light_of(gamut, signal.r), light_of(gamut, signal.g), light_of(gamut, signal.b)};
    const auto lab = kOklabFromRoots * std::array{std::cbrt(cones[0]), std::cbrt(cones[1]), std::cbrt(cones[2])};
    return {lab[0], lab[1], lab[2]};
}

double hue_difference_deg(const Oklab& a, const Oklab& b) {
    const double difference = oklch_from_oklab(a).hue_deg - oklch_from_oklab(b).hue_deg;
    return std::abs(std::remainder(difference, 360.0));
}

/// Colours of all six faces, corners and edges, moved outward by `step`.
std::vector<RGBd> colours_off_the_faces(double step) {
    std::vector<RGBd> colours;
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i <= 100; ++i) {
            for (int j = 0; j <= 100; ++j) {
                const auto k = static_cast<std::size_t>(face % 3);
                std::array<double, 3> c{};
                c[k] = face < 3 ? -step : 1.0 + step;
                c[(k + 1) % 3] = i / 100.0;
                c[(k + 2) % 3] = j / 100.0;
                colours.push_back({c[0], c[1], c[2]});
            }
        }
    }
    return colours;
}

RGBd clipped(const RGBd& c) { return map_gamut(GamutClip{}, {}, c); }

TEST(GamutMapper, AnyBitsComeOutInRangeButOfNone) {
    for_each_alternative<GamutMapper>([]<class T>(const T& mapper) {
        Pcg32 random(40);
        std::vector<RGB> pixels(50000);
        for (RGB& p : pixels) {
            p = {std::bit_cast<float>(random.next()), std::bit_cast<float>(random.next()),
                 std::bit_cast<float>(random.next())};
        }
        const GamutCounts counts = map_gamut(GamutMapper(mapper), display_gamut(SrgbDisplay{}), pixels);
        for (const RGB& p : pixels) {
            for (const float v : {p.r, p.g, p.b}) {
                ASSERT_FALSE(std::isnan(v));
                if constexpr (!std::is_same_v<T, GamutNone>) {
                    ASSERT_TRUE(v >= 0.0f && v <= 1.0f && !std::signbit(v));
                }
            }
        }
        EXPECT_GT(counts.outside, 0);
        EXPECT_GT(counts.nan, 0);
    });
}

TEST(GamutMapper, ColoursInsideStayAsTheyAreAndAreNotCounted) {
    for_each_alternative<GamutMapper>([](const auto& mapper) {
        Pcg32 random(41);
        std::vector<RGB> pixels{{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}, {1.0f, 0.0f, 0.5f}};
        for (int i = 0; i < 1000; ++i) {
            pixels.push_back({random.next_float(), random.next_float(), random.next_float()});
        }
        const std::vector<RGB> before = pixels;
        EXPECT_EQ(map_gamut(GamutMapper(mapper), display_gamut(SrgbDisplay{}), pixels), GamutCounts{});
        EXPECT_EQ(pixels, before);
    });
}

// (v, v, v) of any v is what clipping makes of it, on every display.
TEST(GamutMapper, GreysStayGrey) {
    for_each_alternative<GamutMapper>([]<class T>(const T& mapper) {
        if constexpr (std::is_same_v<T, GamutNone>) return;
        for (const DisplayGamut& gamut : all_gamuts()) {
            for (const double v : {-1e6, -0.5, -1e-5, 0.0, 0.25, 1.0, 1.00001, 2.0, 1e6}) {
                const RGBd grey = map_gamut(GamutMapper(mapper), gamut, RGBd{v, v, v});
                EXPECT_EQ(grey, (RGBd{std::clamp(v, 0.0, 1.0), std::clamp(v, 0.0, 1.0), std::clamp(v, 0.0, 1.0)})) << v;
            }
        }
    });
}

TEST(GamutMapper, SinglePrecisionIsWithinItsToleranceOfTheTwin) {
    for_each_alternative<GamutMapper>([](const auto& mapper) {
        for (const DisplayGamut& gamut : all_gamuts()) {
            const std::vector<RGB> before = colours_about_the_gamut(42, 3000);
            std::vector<RGB> after = before;
            (void)map_gamut(GamutMapper(mapper), gamut, after);
            for (std::size_t i = 0; i < before.size(); ++i) {
                const RGBd exact = map_gamut(GamutMapper(mapper), gamut, wide(before[i]));
                ASSERT_LE(distance(wide(after[i]), exact), 6e-8) << mapper.kName;
            }
        }
    });
}

// A mapper is continuous where it begins to act, on all faces up to edges and corners: whatever leaves the gamut by a
// little comes back by little. Not of black and white: what is no lighter than black, no darker than white, is these.
TEST(GamutMapper, IsContinuousAcrossTheBoundary) {
    for_each_alternative<GamutMapper>([](const auto& mapper) {
        for (const DisplayGamut& gamut : all_gamuts()) {
            for (const double step : {1e-5, 1e-7, 1e-9}) {
                double worst = 0.0;
                for (const RGBd& color : colours_off_the_faces(step)) {
                    const double sum = color.r + color.g + color.b;
                    if (sum < 0.01 || sum > 2.99) continue;
                    worst = std::max(worst, distance(map_gamut(GamutMapper(mapper), gamut, color), clipped(color)));
                }
                // Desaturation moves 1 / 0.059 times as far as blue, which has so little of BT.2020's luminance, is
                // off.
                const double slope =
                    std::is_same_v<std::remove_cvref_t<decltype(mapper)>, GamutDesaturate> ? 17.0 : 1.01;
                EXPECT_LT(worst, slope * step) << mapper.kName << ' ' << step;
            }
        }
    });
}

// What rounding has put outside is clipped by the fast path: there is no more than that between it and the twin.
TEST(GamutMapper, ClippingWithinTheToleranceIsNearTheTwin) {
    for_each_alternative<GamutMapper>([](const auto& mapper) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(mapper)>, GamutNone>) return;
        for (const DisplayGamut& gamut : all_gamuts()) {
            for (const RGBd& color : colours_off_the_faces(9e-7)) {
                const RGB single{static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
                std::vector<RGB> fast{single};
                (void)map_gamut(GamutMapper(mapper), gamut, fast);
                ASSERT_LE(distance(wide(fast[0]), map_gamut(GamutMapper(mapper), gamut, wide(single))),
                          17.0 * kGamutTolerance)
                    << mapper.kName << ' ' << color.r << ' ' << color.g << ' ' << color.b;
            }
        }
    });
}

TEST(GamutMapper, CountsTheSamePixelsWhateverItMakesOfThem) {
    const DisplayGamut gamut = display_gamut(SrgbDisplay{});
    std::vector<RGB> pixels = colours_about_the_gamut(44, 1000);
    pixels[3] = {kNan, 2.0f, 0.0f};
    std::vector<RGB> clipped = pixels;
    const GamutCounts expected = map_gamut(GamutClip{}, gamut, clipped);
    EXPECT_GT(expected.outside, 500);
    for_each_alternative<GamutMapper>([&](const auto& mapper) {
        std::vector<RGB> copy = pixels;
        EXPECT_EQ(map_gamut(GamutMapper(mapper), gamut, copy), expected);
    });
}

TEST(GamutNone, LeavesWhatIsOutside) {
    std::vector<RGB> pixels{{1.5f, -0.25f, kNan}, {kInf, -kInf, 1.0f}};
    const GamutCounts counts = map_gamut(GamutNone{}, display_gamut(SrgbDisplay{}), pixels);
    EXPECT_TRUE(same_bits(pixels[0], {1.5f, -0.25f, 0.0f}));
    EXPECT_TRUE(same_bits(pixels[1], {kInf, -kInf, 1.0f}));
    EXPECT_EQ(counts, (GamutCounts{1, 1, kInf}));
}

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

TEST(GamutClip, TakesEachComponentByItself) {
    std::vector<RGB> pixels{{1.5f, -0.25f, 0.5f}, {-0.0f, kNan, 2.0f}, {kInf, -kInf, 1.0f}, {1.0f, 0.0f, 0.0f}};
    const GamutCounts counts = map_gamut(GamutClip{}, display_gamut(SrgbDisplay{}), pixels);
    EXPECT_TRUE(same_bits(pixels[0], {1.0f, 0.0f, 0.5f}));
    EXPECT_TRUE(same_bits(pixels[1], {0.0f, 0.0f, 1.0f}));
    EXPECT_TRUE(same_bits(pixels[2], {1.0f, 0.0f, 1.0f}));
    EXPECT_EQ(counts, (GamutCounts{2, 1, kInf}));
}

TEST(GamutClip, RoundingIsNotOutside) {
    std::vector<RGB> pixels{{std::nextafter(1.0f, 2.0f), -1e-7f, 0.0f}};
    GamutCounts counts = map_gamut(GamutClip{}, display_gamut(SrgbDisplay{}), pixels);
    EXPECT_EQ(counts.outside, 0);
    EXPECT_FLOAT_EQ(counts.largest_excess, std::nextafter(1.0f, 2.0f) - 1.0f);
    pixels = {{1.0f + 2.0f * kGamutTolerance, 0.0f, 0.0f}, {0.0f, -2.0f * kGamutTolerance, 0.0f}};
    counts = map_gamut(GamutClip{}, display_gamut(SrgbDisplay{}), pixels);
    EXPECT_EQ(counts.outside, 2);
}

TEST(GamutCounts, Add) {
    GamutCounts a{1, 2, 0.5f};
    a += {10, 20, 0.25f};
    EXPECT_EQ(a, (GamutCounts{11, 22, 0.5f}));
}

}  // namespace
}  // namespace emulsion
