#include "display/halftone.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "dither_fixture.h"

namespace emulsion {
namespace {

// 5, 10 and 17 levels, and each is one pixel more of every cell.
TEST(Halftone, ClassicalCellsHaveALevelMoreThanPixels) {
    for (const int size : {2, 3, 4}) {
        const int pixels = size * size;
        Image<std::uint16_t> before(size, size);
        for (int level = 0; level <= pixels; ++level) {
            const float value = static_cast<float>(level) / static_cast<float>(pixels);
            const Image<std::uint16_t> codes =
                quantize(Halftone{size, kUprightScreens}, constant_grey(size, size, value).view(), {0, 1}, 1);
            int white = 0;
            for (std::size_t i = 0; i < codes.pixels().size(); ++i) {
                white += codes.pixels()[i];
                EXPECT_GE(codes.pixels()[i], before.pixels()[i]) << "a pixel that was white is black again";
            }
            EXPECT_EQ(white, level) << size;
            before = codes;
        }
    }
}

// The black dot of a cell of 4 in a light grey is its middle; a print's dots are one piece.
TEST(Halftone, DotIsOnePiece) {
    const Image<std::uint16_t> codes =
        quantize(Halftone{4, kUprightScreens}, constant_grey(4, 4, 0.75f).view(), {0, 1}, 1);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) EXPECT_EQ(codes(x, y), x == 0 || x == 3 || y == 0 || y == 3 ? 1 : 0);
    }
}

TEST(Halftone, PlatesAreTurned) {
    const Halftone plates{4, kPlateScreens};
    EXPECT_EQ(halftone_cell(plates, 0, 3), (HalftoneCell{4, 1}));  // 14.0 degrees
    EXPECT_EQ(halftone_cell(plates, 1, 3), (HalftoneCell{1, 4}));  // 76.0
    EXPECT_EQ(halftone_cell(plates, 2, 3), (HalftoneCell{4, 0}));
    EXPECT_EQ(halftone_cell(plates, 0, 1), (HalftoneCell{3, 3}));  // 45
    EXPECT_EQ(halftone_cell(Halftone{8, kPlateScreens}, 0, 3), (HalftoneCell{8, 2}));
    EXPECT_EQ(halftone_cell(Halftone{5, kUprightScreens}, 1, 3), (HalftoneCell{5, 0}));
}

// The screen is the same one cell further, along either side; and every rank is there as often as any other.
TEST(Halftone, RanksRepeatWithTheCell) {
    for (int size = 2; size <= 16; ++size) {
        for (int channel = 0; channel < 3; ++channel) {
            const HalftoneCell cell = halftone_cell(Halftone{size, kPlateScreens}, channel, 3);
            const int side = cell.pixels();
            const std::vector<int> ranks = halftone_ranks(cell);
            const auto rank = [&](int x, int y) {
                const int column = (x % side + side) % side, row = (y % side + side) % side;
                return ranks[static_cast<std::size_t>(row * side + column)];
            };
            std::vector<int> counts(static_cast<std::size_t>(side));
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    ASSERT_EQ(rank(x, y), rank(x + cell.a, y + cell.b));
                    ASSERT_EQ(rank(x, y), rank(x - cell.b, y + cell.a));
                    ++counts[static_cast<std::size_t>(rank(x, y))];
                }
            }
            EXPECT_TRUE(std::ranges::all_of(counts, [&](int count) { return count == side; })) << size;
        }
    }
}

TEST(Halftone, ChannelsHaveTheirScreens) {
    Image<RGB> picture(68, 68);
    for (RGB& p : picture.pixels()) p = {0.6f, 0.6f, 0.6f};
    const Image<CodeRGB> upright = quantize(Halftone{4, kUprightScreens}, picture.view(), {0, 1}, 1);
    for (const CodeRGB& c : upright.pixels()) EXPECT_TRUE(c.r == c.g && c.g == c.b);
    const Image<CodeRGB> plates = quantize(Halftone{4, kPlateScreens}, picture.view(), {0, 1}, 1);
    std::array<int, 3> white{}, differ{};
    for (const CodeRGB& c : plates.pixels()) {
        white[0] += c.r, white[1] += c.g, white[2] += c.b;
        differ[0] += c.r != c.g ? 1 : 0, differ[1] += c.g != c.b ? 1 : 0, differ[2] += c.b != c.r ? 1 : 0;
    }
    // 0.6 of 17, 17 and 16 pixels are 10.2, 10.2 and 9.6: 10 each where the middles of levels are the thresholds
    EXPECT_EQ(white, (std::array{68 * 68 * 10 / 17, 68 * 68 * 10 / 17, 68 * 68 * 10 / 16}));
    for (const int pixels : differ) EXPECT_GT(pixels, 68 * 68 / 4);
}

}  // namespace
}  // namespace emulsion
