#include "display/gamut_clip.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "display/gamut_mapper.h"
#include "gamut_fixture.h"

namespace emulsion {
namespace {

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

}  // namespace
}  // namespace emulsion
