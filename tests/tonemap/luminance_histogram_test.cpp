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
    EXPECT_EQ(LuminanceHistogram::lower_end(0), 0.0);
    EXPECT_EQ(LuminanceHistogram::lower_end(kBins), 0x1p128);
    for (int bin = 0; bin < kBins; ++bin) {
        const double low = LuminanceHistogram::lower_end(bin), high = LuminanceHistogram::lower_end(bin + 1);
        ASSERT_LT(low, high);
        if (low < 0x1p-126) continue;  // denormals are equally far apart
        ASSERT_GT(high / low, 1.0 + 1.0 / 64.0) << bin;
        ASSERT_LE(high / low, 1.0 + 1.0 / 32.0) << bin;
    }
    EXPECT_EQ(LuminanceHistogram::lower_end(127 * 32), 1.0);
    EXPECT_EQ(LuminanceHistogram::lower_end(127 * 32 + 16), 1.5);
}

TEST(LuminanceHistogram, ValuesAreCountedBetweenTheEndsOfTheirBin) {
    EXPECT_EQ(bin_of(std::numeric_limits<float>::denorm_min()), 0);
    EXPECT_EQ(bin_of(std::numeric_limits<float>::max()), kBins - 1);
    EXPECT_EQ(bin_of(1.0f), 127 * 32);
    EXPECT_EQ(bin_of(std::nextafter(1.0f, 0.0f)), 127 * 32 - 1);
    Pcg32 random(1);
    for (int i = 0; i < 200; ++i) {
        const auto value = std::bit_cast<float>(1u + random.next() % 0x7f7fffffu);
        const int bin = bin_of(value);
        ASSERT_GE(bin, 0);
        EXPECT_GE(double{value}, LuminanceHistogram::lower_end(bin));
        EXPECT_LT(double{value}, LuminanceHistogram::lower_end(bin + 1));
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

// Four values in the bin [1, 1 + 1/32): they count as evenly spread.
TEST(LuminanceHistogram, RanksWithinABinAreInterpolated) {
    LuminanceHistogram histogram;
    EXPECT_EQ(histogram.value_of_rank(0.0), 0.0);
    for (int i = 0; i < 4; ++i) histogram.add(1.01f);
    histogram.add(8.0f);
    EXPECT_DOUBLE_EQ(histogram.value_of_rank(0.0), 1.0);
    EXPECT_DOUBLE_EQ(histogram.value_of_rank(1.0), 1.0 + 1.0 / 128.0);
    EXPECT_DOUBLE_EQ(histogram.value_of_rank(3.0), 1.0 + 3.0 / 128.0);
    EXPECT_DOUBLE_EQ(histogram.value_of_rank(4.0), 8.0);
    EXPECT_DOUBLE_EQ(histogram.value_of_rank(5.0), 8.25);
}

}  // namespace
}  // namespace emulsion
