#include "display/gamut_mapper.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "gamut_fixture.h"

namespace emulsion {
namespace {

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

TEST(GamutCounts, Add) {
    GamutCounts a{1, 2, 0.5f};
    a += {10, 20, 0.25f};
    EXPECT_EQ(a, (GamutCounts{11, 22, 0.5f}));
}

}  // namespace
}  // namespace emulsion
