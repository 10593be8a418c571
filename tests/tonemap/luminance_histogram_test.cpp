#include "tonemap/luminance_histogram.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

constexpr int kBins = LuminanceHistogram::kBins;
constexpr int kOfOne = 149 * 32;  // the bin of 1: the least float is 2^-149

/// The bin that a histogram of this one value counts it in; -1 if none or several.
int bin_of(float value) {
    LuminanceHistogram histogram;
    histogram.add(value);
    int found = -1;
    for (int bin = 0; bin < kBins; ++bin) {
        if (histogram.count(bin) == 1 && found < 0) found = bin;
    }
    return histogram.total() == 1 ? found : -1;
}

TEST(LuminanceHistogram, BinsCoverAllPositiveFloatsInOrder) {
    EXPECT_EQ(LuminanceHistogram::lower_end(0), double{std::numeric_limits<float>::denorm_min()});
    EXPECT_EQ(LuminanceHistogram::lower_end(kBins), 0x1p128);
    for (int bin = 0; bin < kBins; ++bin) {
        const double low = LuminanceHistogram::lower_end(bin), high = LuminanceHistogram::lower_end(bin + 1);
        ASSERT_LT(low, high);
        ASSERT_GT(high / low, 1.0 + 1.0 / 64.0) << bin;
        ASSERT_LE(high / low, 1.0 + 1.0 / 32.0) << bin;
    }
    EXPECT_EQ(LuminanceHistogram::lower_end(23 * 32), double{std::numeric_limits<float>::min()});
    EXPECT_EQ(LuminanceHistogram::lower_end(kOfOne), 1.0);
    EXPECT_EQ(LuminanceHistogram::lower_end(kOfOne + 16), 1.5);
}

TEST(LuminanceHistogram, ValuesAreCountedBetweenTheEndsOfTheirBin) {
    EXPECT_EQ(bin_of(std::numeric_limits<float>::denorm_min()), 0);
    EXPECT_EQ(bin_of(std::numeric_limits<float>::max()), kBins - 1);
    EXPECT_EQ(bin_of(1.0f), kOfOne);
    EXPECT_EQ(bin_of(std::nextafter(1.0f, 0.0f)), kOfOne - 1);
    Pcg32 random(1);
    for (int i = 0; i < 200; ++i) {
        const auto value = std::bit_cast<float>(1u + random.next() % 0x7f7fffffu);
        const int bin = bin_of(value);
        ASSERT_GE(bin, 0);
        EXPECT_GE(double{value}, LuminanceHistogram::lower_end(bin));
        EXPECT_LT(double{value}, LuminanceHistogram::lower_end(bin + 1));
    }
}

// In every octave of denormals that has so many: the first value of each bin, and the last.
TEST(LuminanceHistogram, DenormalsHaveAsFineBins) {
    for (int octave = 5; octave < 23; ++octave) {
        for (std::uint32_t k = 0; k < 32; ++k) {
            const std::uint32_t first = (32u + k) << static_cast<unsigned>(octave - 5),
                                last = ((33u + k) << static_cast<unsigned>(octave - 5)) - 1u;
            const int bin = octave * 32 + static_cast<int>(k);
            ASSERT_EQ(bin_of(std::bit_cast<float>(first)), bin);
            ASSERT_EQ(bin_of(std::bit_cast<float>(last)), bin);
            ASSERT_EQ(LuminanceHistogram::lower_end(bin), double{std::bit_cast<float>(first)});
        }
    }
}

TEST(LuminanceHistogram, HistogramsAdd) {
    LuminanceHistogram a, b, all;
    Pcg32 random(2);
    for (int i = 0; i < 1000; ++i) {
        const float value = 0.01f + random.next_float();
        (i % 3 == 0 ? a : b).add(value);
        all.add(value);
    }
    LuminanceHistogram ab = a, ba = b;
    ab += b;
    ba += a;
    EXPECT_EQ(ab, all);
    EXPECT_EQ(ba, all);
    EXPECT_EQ(all.total(), 1000u);
}

TEST(LuminanceHistogram, RankIsThatOfTheSortedValuesToABinsWidth) {
    LuminanceHistogram histogram;
    std::vector<float> values;
    Pcg32 random(3);
    for (int i = 0; i < 5000; ++i) {
        values.push_back(std::pow(10.0f, 12.0f * random.next_float() - 6.0f));
        histogram.add(values.back());
    }
    std::sort(values.begin(), values.end());
    for (int rank = 0; rank < 5000; rank += 7) {
        const double exact = double{values[static_cast<std::size_t>(rank)]};
        EXPECT_NEAR(histogram.value_of_rank(rank) / exact, 1.0, 1.0 / 32.0) << rank;
    }
    EXPECT_NEAR(histogram.value_of_rank(5000.0) / double{values.back()}, 1.0, 1.0 / 32.0);
}

TEST(LuminanceHistogram, MeansAreThoseOfTheValues) {
    LuminanceHistogram histogram;
    for (const float value : {1.001f, 1.002f, 1.03f}) histogram.add(value);
    histogram.add(std::numeric_limits<float>::max());
    EXPECT_NEAR(histogram.mean(kOfOne), (1.001 + 1.002 + 1.03) / 3.0, 3e-5);
    EXPECT_NEAR(histogram.mean(kBins - 1) / double{std::numeric_limits<float>::max()}, 1.0, 3e-5);
}

// A cell holds 2^27 values of the largest place.
TEST(LuminanceHistogram, FullBinsKeepCountAndMean) {
    LuminanceHistogram doubled;
    const float value = std::nextafter(1.03125f, 0.0f);
    doubled.add(value);
    for (int i = 0; i < 26; ++i) doubled += LuminanceHistogram(doubled);
    EXPECT_EQ(doubled.count(kOfOne), LuminanceHistogram::kMostValues / 2);
    EXPECT_EQ(doubled.total(), LuminanceHistogram::kMostValues / 2);
    EXPECT_NEAR(doubled.mean(kOfOne), double{value}, 3e-5);
}

// 4 values of 1.01 and 2 of 1.04 in the next bin, 1.02 being the mean of all six; a gap, and one value of 8.
TEST(LuminanceHistogram, RanksAreInterpolatedBetweenNeighbouringBins) {
    LuminanceHistogram histogram;
    EXPECT_EQ(histogram.value_of_rank(0.0), 0.0);
    for (int i = 0; i < 4; ++i) histogram.add(1.01f);
    for (int i = 0; i < 2; ++i) histogram.add(1.04f);
    histogram.add(8.0f);
    EXPECT_NEAR(histogram.value_of_rank(0.0), 1.01, 4e-5);
    EXPECT_NEAR(histogram.value_of_rank(2.0), 1.01, 4e-5);
    EXPECT_NEAR(histogram.value_of_rank(3.0), 1.015, 4e-5);
    EXPECT_NEAR(histogram.value_of_rank(3.999), 1.02, 6e-5);
    EXPECT_NEAR(histogram.value_of_rank(4.0), 1.02, 4e-5);
    EXPECT_NEAR(histogram.value_of_rank(5.0), 1.04, 4e-5);
    EXPECT_NEAR(histogram.value_of_rank(5.999), 1.04, 4e-5);
    EXPECT_NEAR(histogram.value_of_rank(6.0), 8.0, 3e-4);
    EXPECT_NEAR(histogram.value_of_rank(7.0), 8.0, 3e-4);
}

}  // namespace
}  // namespace emulsion
