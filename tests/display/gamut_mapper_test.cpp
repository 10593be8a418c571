#include "display/gamut_mapper.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"
#include "spectrum/gamut.h"
#include "spectrum/oklab.h"

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

std::vector<DisplayGamut> all_gamuts() {
    std::vector<DisplayGamut> all;
    for_each_alternative<Display>([&](const auto& display) { all.push_back(display_gamut(display)); });
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

/// Of linear RGB, with the display's white as Oklab's own.
Oklab oklab_of(const DisplayGamut& gamut, const RGBd& rgb) {
    const auto cones = gamut.cones_from_rgb * std::array{rgb.r, rgb.g, rgb.b};
    const auto lab = kOklabFromRoots * std::array{std::cbrt(cones[0]), std::cbrt(cones[1]), std::cbrt(cones[2])};
    return {lab[0], lab[1], lab[2]};
}

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

// A mapper is continuous where it begins to act: whatever leaves the gamut by a little comes back by little. Of mixed
// colours: near black and white, where the cube ends in a corner, all that is outside goes to that corner.
TEST(GamutMapper, IsContinuousAcrossTheBoundary) {
    for_each_alternative<GamutMapper>([](const auto& mapper) {
        Pcg32 random(43);
        for (const DisplayGamut& gamut : all_gamuts()) {
            double worst = 0.0;
            for (int i = 0; i < 2000; ++i) {
                std::array<double, 3> face{0.1 + 0.8 * random.next_float(), 0.1 + 0.8 * random.next_float(),
                                           0.1 + 0.8 * random.next_float()};
                const double end = i % 2;
                face[static_cast<std::size_t>(i % 3)] = end;
                for (const double step : {1e-3, 1e-4, 1e-6}) {
                    std::array<double, 3> out = face;
                    out[static_cast<std::size_t>(i % 3)] += end > 0.5 ? step : -step;
                    const RGBd mapped = map_gamut(GamutMapper(mapper), gamut, RGBd{out[0], out[1], out[2]});
                    worst = std::max(worst, distance(mapped, {face[0], face[1], face[2]}) / step);
                }
            }
            EXPECT_LT(worst, 25.0) << mapper.kName;  // 19.2 of oklab, whose cube roots are steep
            testing::Test::RecordProperty(std::string(mapper.kName), std::to_string(worst));
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

TEST(GamutDesaturate, ByHand) {
    // Luminances of sRGB's primaries: 0.2126, 0.7152, 0.0722. Y = 0.5 (to 4 digits), t = 0.5 / 1.5 down to red 0 or so.
    const DisplayGamut even{{0.25, 0.5, 0.25}, {}, {}};
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{-0.5, 0.75, 1.0}), (RGBd{0.0, 0.625, 0.75}));
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{1.5, 0.25, 0.0}), (RGBd{1.0, 0.375, 0.25}));
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{4.0, 0.0, 0.5}), (RGBd{1.0, 1.0, 1.0}));
    EXPECT_EQ(map_gamut(GamutDesaturate{}, even, RGBd{-4.0, 0.0, 0.5}), (RGBd{0.0, 0.0, 0.0}));
}

TEST(GamutOklab, KeepsLightnessAndHueAndStopsAtTheBoundary) {
    for (const DisplayGamut& gamut : all_gamuts()) {
        for (const RGB& color : colours_about_the_gamut(46, 3000)) {
            const RGBd after = map_gamut(GamutOklab{}, gamut, wide(color));
            if (gamut_margin(wide(color)) >= 0.0) continue;
            const Oklab wanted = oklab_of(gamut, wide(color)), found = oklab_of(gamut, after);
            EXPECT_NEAR(gamut_margin(after), 0.0, 1e-14);
            EXPECT_NEAR(found.l, std::clamp(wanted.l, 0.0, 1.0), 1e-8);
            // Across the direction of the wanted hue there is nothing, along it no more than was.
            const double chroma = std::hypot(wanted.a, wanted.b);
            EXPECT_NEAR((found.a * wanted.b - found.b * wanted.a) / chroma, 0.0, 1e-7);
            const double kept = (found.a * wanted.a + found.b * wanted.b) / chroma;
            EXPECT_GT(kept, -1e-7);
            EXPECT_LT(kept, chroma);
        }
    }
}

// Of one lightness and hue, all colours outside go to the same place, and those inside stay: chroma out never falls.
TEST(GamutOklab, ChromaNeverFalls) {
    Pcg32 random(47);
    for (const DisplayGamut& gamut : all_gamuts()) {
        const Matrix3 oklab_from_roots = kOklabFromRoots, roots_from_oklab = inverse(oklab_from_roots);
        for (int i = 0; i < 300; ++i) {
            const double lightness = 0.02 + 0.96 * random.next_float(), hue = 6.2832 * random.next_float();
            double last = 0.0;
            for (double chroma = 0.01; chroma < 0.5; chroma += 0.01) {
                auto cones = roots_from_oklab * std::array{lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
                for (double& cone : cones) cone *= cone * cone;
                const auto rgb = gamut.rgb_from_cones * cones;
                const Oklab found = oklab_of(gamut, map_gamut(GamutOklab{}, gamut, RGBd{rgb[0], rgb[1], rgb[2]}));
                EXPECT_GE(std::hypot(found.a, found.b), last - 1e-6) << lightness << ' ' << hue << ' ' << chroma;
                last = std::hypot(found.a, found.b);
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
    EXPECT_NEAR(hue_deg(map_gamut(GamutOklab{}, gamut, blue)), hue_deg(blue), 1e-4);
    EXPECT_GT(std::abs(hue_deg(map_gamut(GamutClip{}, gamut, blue)) - hue_deg(blue)), 1.0);
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
