#include "display/blue_noise.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "display/void_and_cluster.h"
#include "dither_fixture.h"
#include "power_spectrum.h"

namespace emulsion {
namespace {

constexpr double kQuarterNyquist = 0.125;  // cycles a pixel

/// Share of power below a quarter of Nyquist's frequency of a constant of one bit.
double low_share(const Dither& dither, double grey) {
    const Image<float> picture = constant_grey(128, 128, static_cast<float>(grey));
    return low_frequency_share(quantize(dither, picture.view(), {0, 1}, 1), kQuarterNyquist);
}

TEST(VoidAndCluster, EveryRankComesOnce) {
    for (const int size : {2, 3, 16, 33}) {
        std::vector<std::uint16_t> ranks = void_and_cluster(size, 7);
        std::ranges::sort(ranks);
        std::vector<std::uint16_t> all(ranks.size());
        std::iota(all.begin(), all.end(), std::uint16_t{0});
        EXPECT_EQ(ranks, all) << size;
    }
}

TEST(VoidAndCluster, DependsOnTheSeedAndOnNothingElse) {
    EXPECT_EQ(void_and_cluster(16, 7), void_and_cluster(16, 7));
    EXPECT_NE(void_and_cluster(16, 7), void_and_cluster(16, 8));
}

// The tile of the library is what its generator makes now.
TEST(BlueNoise, TileIsThatOfTheGenerator) {
    const std::span<const std::uint16_t> ranks = blue_noise_ranks(64);
    EXPECT_EQ(std::vector<std::uint16_t>(ranks.begin(), ranks.end()), void_and_cluster(64, 1));
    EXPECT_EQ(blue_noise_ranks(128).size(), 128u * 128u);
}

TEST(BlueNoise, TileHasNoLowFrequencies) {
    for (const ParameterWord& size : kBlueNoiseSizes) {
        Image<std::uint16_t> tile(size.value, size.value);
        std::ranges::copy(blue_noise_ranks(size.value), tile.pixels().begin());
        EXPECT_LT(low_frequency_share(tile, kQuarterNyquist), 1e-4) << size.word;  // 1e-5 and 2e-5
    }
}

// Under 2 % from 1/32 to 31/32: 0.9 % there and 0.1 % in the middle. Dots of greys nearer to the ends are farther apart
// than a wave of a quarter of Nyquist's frequency is long, so that nothing can keep their power above it: 2.3 % at
// 1/64.
TEST(BlueNoise, GreysHaveNoLowFrequencies) {
    for (const ParameterWord& size : kBlueNoiseSizes) {
        for (const double grey : {1.0 / 32.0, 1.0 / 16.0, 0.1, 0.2, 1.0 / 3.0, 0.5, 0.7, 0.9, 31.0 / 32.0}) {
            EXPECT_LT(low_share(BlueNoise{size.value}, grey), 0.01) << grey;
        }
    }
    EXPECT_NEAR(low_share(BlueNoise{}, 0.5), 0.001, 0.0005);
    EXPECT_NEAR(low_share(BlueNoise{}, 1.0 / 64.0), 0.023, 0.003);
}

// Beside it: white noise has what belongs to the area, pi / 64 = 4.9 % (its standard deviation is 0.25 %). Floyd and
// Steinberg's has less than blue noise in the middle, and more in the lights and darks: start-up and worms.
TEST(BlueNoise, BesideOthers) {
    for (const double grey : {1.0 / 32.0, 0.2, 0.5, 0.9}) EXPECT_NEAR(low_share(WhiteNoise{}, grey), 0.0465, 0.007);
    EXPECT_LT(low_share(FloydSteinberg{}, 0.5), 0.0005);
    EXPECT_NEAR(low_share(FloydSteinberg{}, 0.1), 0.0007, 0.0003);
    EXPECT_NEAR(low_share(FloydSteinberg{}, 1.0 / 32.0), 0.026, 0.005);
    EXPECT_NEAR(low_share(BlueNoise{}, 1.0 / 32.0), 0.009, 0.001);
}

// The channels have the tile in different places: a grey's dots differ.
TEST(BlueNoise, ChannelsDiffer) {
    Image<RGB> picture(64, 64);
    for (RGB& p : picture.pixels()) p = {0.5f, 0.5f, 0.5f};
    const Image<CodeRGB> codes = quantize(BlueNoise{}, picture.view(), {0, 1}, 1);
    int same = 0;
    for (const CodeRGB& c : codes.pixels()) same += c.r == c.g && c.g == c.b ? 1 : 0;
    EXPECT_NEAR(same, 64 * 64 / 4, 5.0 * 28.0);  // five deviations of independent dots
}

}  // namespace
}  // namespace emulsion
