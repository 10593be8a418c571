#include "display/bayer.h"

#include <array>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "dither_fixture.h"

namespace emulsion {
namespace {

// Bayer's matrix of 4 x 4, as it is printed everywhere.
TEST(Bayer, RanksOfFour) {
    constexpr std::array<std::array<int, 4>, 4> kRanks = {
        {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) EXPECT_EQ(bayer_rank(x, y, 4), kRanks.at(y).at(x)) << x << ", " << y;
    }
}

TEST(Bayer, EveryRankComesOnce) {
    for (const ParameterWord& size : kBayerSizes) {
        std::vector<int> counts(static_cast<std::size_t>(size.value * size.value));
        for (int y = 0; y < size.value; ++y) {
            for (int x = 0; x < size.value; ++x) ++counts[static_cast<std::size_t>(bayer_rank(x, y, size.value))];
        }
        for (const int count : counts) ASSERT_EQ(count, 1) << size.word;
    }
}

// One bit: the dots of a grey of k / size^2 are the ranks that are nearest to white, k of them; grey stays grey.
TEST(Bayer, GreysAreCountsOfDots) {
    for (int k = 0; k <= 16; ++k) {
        Image<RGB> picture(4, 4);
        const float value = static_cast<float>(k) / 16.0f;
        for (RGB& p : picture.pixels()) p = {value, value, value};
        const Image<CodeRGB> codes = quantize(Bayer{4}, picture.view(), {0, 1}, 1);
        int dots = 0;
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                const std::uint16_t dot = bayer_rank(x, y, 4) >= 16 - k ? 1 : 0;
                EXPECT_EQ(codes(x, y), (CodeRGB{dot, dot, dot}));
                dots += codes(x, y).g;
            }
        }
        EXPECT_EQ(dots, k);
    }
}

TEST(Bayer, OtherSizesAreRefused) {
    EXPECT_THROW((void)quantize(Bayer{6}, Image<float>(2, 2).view(), {}, 1), std::invalid_argument);
    EXPECT_THROW((void)parse_named<Dither>("bayer:size=1", "dither"), std::invalid_argument);
    EXPECT_EQ(parse_named<Dither>("bayer:size=256", "dither"), Dither(Bayer{256}));
}

}  // namespace
}  // namespace emulsion
