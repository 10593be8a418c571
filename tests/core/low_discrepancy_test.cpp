#include "core/low_discrepancy.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "support/chi_square.h"

namespace emulsion {
namespace {

TEST(ReverseBits, IsItsOwnInverseAndMirrorsPowersOfTwo) {
    for (int i = 0; i < 32; ++i) EXPECT_EQ(reverse_bits(1u << i), 1u << (31 - i));
    for (std::uint32_t x = 1; x < 100000; x = x * 5 + 3) EXPECT_EQ(reverse_bits(reverse_bits(x)), x);
}

/// Column j of the generator matrix: the direction number of bit j of the index.
TEST(SobolSecond, MatchesTheRecurrenceOfItsDirectionNumbers) {
    std::uint32_t direction = 1u << 31;
    for (int j = 0; j < 32; ++j, direction ^= direction >> 1) EXPECT_EQ(sobol_second(1u << j), direction) << j;
    EXPECT_EQ(sobol_second(0x12345678u ^ 0x0f0f1234u), sobol_second(0x12345678u) ^ sobol_second(0x0f0f1234u));
}

TEST(SobolSecond, MatchesPublishedFirstPoints) {
    const double expected[] = {0.0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875};
    for (std::uint32_t i = 0; i < 8; ++i) EXPECT_EQ(sobol_second(i) * 0x1p-32, expected[i]) << i;
}

TEST(OwenScramble, FlipsEachBitByTheBitsAboveItAlone) {
    for (std::uint32_t seed : {1u, 77u, 0xdeadbeefu}) {
        for (int bit = 0; bit < 32; ++bit) {
            // Two numbers that agree above `bit` and differ there must do so after scrambling.
            const std::uint32_t a = 0x9e3779b9u, b = a ^ (1u << bit);
            const std::uint32_t difference = owen_scramble(a, seed) ^ owen_scramble(b, seed);
            EXPECT_EQ(difference >> bit, 1u) << bit;
        }
    }
}

/// A (0, 2)-net: of 2^k points, every elementary interval of area 2^-k holds exactly one.
TEST(ScrambledSobol, AlignedPowersOfTwoAreNets) {
    for (const std::uint64_t seed : {0u, 5u, 123456789u}) {
        for (int k = 1; k <= 8; ++k) {
            const std::uint32_t count = 1u << k;
            for (const std::uint32_t begin : {0u, 3u * count}) {
                for (int x_bits = 0; x_bits <= k; ++x_bits) {
                    std::set<std::uint32_t> cells;
                    for (std::uint32_t i = begin; i < begin + count; ++i) {
                        const auto [x, y] = scrambled_sobol_2d(i, seed);
                        const auto column = static_cast<std::uint32_t>(x * static_cast<float>(1u << x_bits));
                        const auto row = static_cast<std::uint32_t>(y * static_cast<float>(1u << (k - x_bits)));
                        cells.insert((column << 16) | row);
                    }
                    EXPECT_EQ(cells.size(), count) << "2^" << k << " points from " << begin << ", seed " << seed;
                }
            }
        }
    }
}

TEST(ScrambledSobol, OneDimensionIsStratified) {
    std::set<int> cells;
    for (std::uint32_t i = 64; i < 128; ++i) cells.insert(static_cast<int>(scrambled_sobol_1d(i, 9) * 64.0f));
    EXPECT_EQ(cells.size(), 64u);
}

TEST(Permuted, IsAPermutationForEveryCount) {
    for (std::uint32_t count = 1; count < 200; ++count) {
        for (const std::uint32_t seed : {0u, 1u, 0x12345678u}) {
            std::vector<std::uint32_t> seen(count);
            for (std::uint32_t i = 0; i < count; ++i) seen[i] = permuted(i, count, seed);
            std::sort(seen.begin(), seen.end());
            for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(seen[i], i) << count << " seed " << seed;
        }
    }
}

/// Every place is equally likely for every index: a chi-square test that fails by chance once in 1e6 seeds. Each
/// permutation fills every row and column once, so that Pearson's sum over k x k cells has (k - 1)^2 degrees of freedom
/// and is k/(k - 1) times too large.
TEST(Permuted, SpreadsOverAllPlaces) {
    constexpr std::uint32_t kCount = 16, kSeeds = 20000;
    std::vector<double> hits(kCount * kCount);
    for (std::uint32_t s = 0; s < kSeeds; ++s) {
        const auto seed = static_cast<std::uint32_t>(mix_bits(s));
        for (std::uint32_t i = 0; i < kCount; ++i) ++hits[i * kCount + permuted(i, kCount, seed)];
    }
    const std::vector<double> expected(hits.size(), static_cast<double>(kSeeds) / kCount);
    const double statistic = testing::chi_square_test(hits, expected).statistic * (kCount - 1.0) / kCount;
    EXPECT_GT(testing::chi_square_tail(statistic, (kCount - 1.0) * (kCount - 1.0)), 1e-6);
}

}  // namespace
}  // namespace emulsion
