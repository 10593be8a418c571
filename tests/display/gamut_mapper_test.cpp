#include "display/gamut_mapper.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

bool same_bits(const RGB& a, const RGB& b) {
    return std::bit_cast<std::uint32_t>(a.r) == std::bit_cast<std::uint32_t>(b.r) &&
           std::bit_cast<std::uint32_t>(a.g) == std::bit_cast<std::uint32_t>(b.g) &&
           std::bit_cast<std::uint32_t>(a.b) == std::bit_cast<std::uint32_t>(b.b);
}

TEST(GamutMapper, AnyBitsComeOutInRange) {
    for_each_alternative<GamutMapper>([](const auto& mapper) {
        Pcg32 random(40);
        std::vector<RGB> pixels(50000);
        for (RGB& p : pixels) {
            p = {std::bit_cast<float>(random.next()), std::bit_cast<float>(random.next()),
                 std::bit_cast<float>(random.next())};
        }
        const GamutCounts counts = map_gamut(GamutMapper(mapper), display_gamut(SrgbDisplay{}), pixels);
        for (const RGB& p : pixels) {
            for (const float v : {p.r, p.g, p.b}) ASSERT_TRUE(v >= 0.0f && v <= 1.0f && !std::signbit(v)) << v;
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
