#include "core/random.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/chi_square.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;

/// The multiplicative inverse of an odd number modulo 2^64, by Newton's iteration.
constexpr std::uint64_t inverse_modulo_2_64(std::uint64_t odd) {
    std::uint64_t inverse = odd;
    for (int i = 0; i < 6; ++i) inverse *= 2u - odd * inverse;
    return inverse;
}

/// Undoes x ^ (x >> shift).
constexpr std::uint64_t undo_xorshift(std::uint64_t y, int shift) {
    std::uint64_t x = y;
    for (int done = shift; done < 64; done += shift) x = y ^ (x >> shift);
    return x;
}

/// The inverse of mix_bits. That there is one shows that mix_bits never maps two values to one.
constexpr std::uint64_t unmix_bits(std::uint64_t x) {
    x = undo_xorshift(x, 31) * inverse_modulo_2_64(0x94d049bb133111ebu);
    x = undo_xorshift(x, 27) * inverse_modulo_2_64(0xbf58476d1ce4e5b9u);
    return undo_xorshift(x, 30);
}

TEST(MixBits, HasAnInverse) {
    Pcg32 random(1);
    for (std::uint64_t i = 0; i < 100000; ++i) {
        const std::uint64_t x = (std::uint64_t{random.next()} << 32u) | random.next();
        ASSERT_EQ(unmix_bits(mix_bits(x)), x);
        ASSERT_EQ(mix_bits(unmix_bits(x)), x);
        ASSERT_EQ(unmix_bits(mix_bits(i)), i);
    }
}

TEST(MixBits, IsTheFinaliserOfSplitMix64) {
    // The first outputs of splitmix64.c (Vigna) for the seed 1234567: mixes of multiples of the golden ratio.
    constexpr std::array<std::uint64_t, 5> kPublished = {
        6457827717110365317u, 3203168211198807973u, 9817491932198370423u, 4593380528125082431u, 16408922859458223821u};
    std::uint64_t state = 1234567;
    for (const std::uint64_t expected : kPublished) {
        state += 0x9e3779b97f4a7c15u;
        EXPECT_EQ(mix_bits(state), expected);
    }
}

TEST(MixBits, OneInputBitFlipsAboutHalfOfTheOutputBits) {
    // For each pair of input and output bit, 4096 trials of a fair coin: the flips lie within 6 standard deviations
    // (192) of 2048. Over 4096 pairs the chance that a fair mixer fails is below 4096 * 2e-9 = 8e-6.
    constexpr int kTrials = 4096;
    Pcg32 random(2);
    std::array<std::array<int, 64>, 64> flips{};
    for (int trial = 0; trial < kTrials; ++trial) {
        const std::uint64_t x = (std::uint64_t{random.next()} << 32u) | random.next();
        for (std::size_t in = 0; in < 64; ++in) {
            const std::uint64_t changed = mix_bits(x) ^ mix_bits(x ^ (std::uint64_t{1} << in));
            for (std::size_t out = 0; out < 64; ++out) flips[in][out] += static_cast<int>((changed >> out) & 1u);
        }
    }
    for (std::size_t in = 0; in < 64; ++in) {
        for (std::size_t out = 0; out < 64; ++out) {
            EXPECT_NEAR(flips[in][out], 0.5 * kTrials, 192) << "input bit " << in << ", output bit " << out;
        }
    }
}

TEST(HashCombine, SmallSeedsAndPixelsNeverMeet) {
    // A hash that only added its two values would give seed 0 at pixel 1 what it gives seed 1 at pixel 0.
    std::unordered_set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
        for (std::uint64_t x = 0; x < 64; ++x) {
            for (std::uint64_t y = 0; y < 64; ++y) seen.insert(hash_combine(hash_combine(seed, x), y));
        }
    }
    EXPECT_EQ(seen.size(), 16u * 64u * 64u);
}

TEST(UnitFloat, StaysBelowOneAndCountsInStepsOf2ToMinus24) {
    EXPECT_EQ(unit_float(0), 0.0f);
    EXPECT_EQ(unit_float(0xffu), 0.0f);
    EXPECT_EQ(unit_float(0x100u), 0x1p-24f);
    EXPECT_EQ(unit_float(0x80000000u), 0.5f);
    EXPECT_EQ(unit_float(0xffffffffu), 1.0f - 0x1p-24f);
    EXPECT_LT(unit_float(0xffffffffu), 1.0f);
}

TEST(UnitDouble, StaysBelowOneAndCountsInStepsOf2ToMinus53) {
    EXPECT_EQ(unit_double(0), 0.0);
    EXPECT_EQ(unit_double(0x7ffu), 0.0);
    EXPECT_EQ(unit_double(0x800u), 0x1p-53);
    EXPECT_EQ(unit_double(std::uint64_t{1} << 63u), 0.5);
    EXPECT_EQ(unit_double(~std::uint64_t{0}), 1.0 - 0x1p-53);
}

TEST(Pcg32, GivesThePublishedNumbers) {
    // Round 1 of the output that pcg32-demo of the PCG C library ships with, initstate 42 and initseq 54. Our seed is
    // mixed before it becomes initstate, so the seed that means 42 is the unmixed 42.
    Pcg32 random(unmix_bits(42), 54);
    std::array<std::uint32_t, 6> numbers{};
    for (std::uint32_t& number : numbers) number = random.next();
    EXPECT_THAT(numbers, ElementsAre(0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu));
}

TEST(Pcg32, SeedsAndStreamsDiffer) {
    std::unordered_set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 64; ++seed) {
        for (std::uint64_t stream = 0; stream < 64; ++stream) {
            Pcg32 random(seed, stream);
            const std::uint64_t high = random.next();
            seen.insert((high << 32u) | random.next());
        }
    }
    EXPECT_EQ(seen.size(), 64u * 64u);
}

TEST(Pcg32, FloatsAreUniform) {
    // Chi-square over 256 cells of 2^20 numbers; a right generator fails once in 1e6 seeds.
    constexpr int kCells = 256, kNumbers = 1 << 20;
    std::array<double, kCells> count{}, expected{};
    Pcg32 random(3);
    for (int i = 0; i < kNumbers; ++i) {
        const float u = random.next_float();
        ASSERT_GE(u, 0.0f);
        ASSERT_LT(u, 1.0f);
        ++count[static_cast<std::size_t>(u * kCells)];
    }
    expected.fill(static_cast<double>(kNumbers) / kCells);
    EXPECT_GT(testing::chi_square_test(count, expected).p_value, 1e-6);
}

TEST(Pcg32, NeighbouringSeedsAreUncorrelated) {
    // The correlation of n independent pairs has a standard deviation of 1/sqrt(n); 5 of them are passed with
    // probability 6e-7.
    constexpr int kPairs = 100000;
    double sum = 0.0;
    for (std::uint64_t seed = 0; seed < kPairs; ++seed) {
        const double a = Pcg32(seed).next_float() - 0.5, b = Pcg32(seed + 1).next_float() - 0.5;
        sum += 12.0 * a * b;
    }
    EXPECT_LT(std::abs(sum / kPairs), 5.0 / std::sqrt(static_cast<double>(kPairs)));
}

}  // namespace
}  // namespace emulsion
