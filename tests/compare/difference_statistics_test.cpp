#include "compare/difference_statistics.h"

#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

DifferenceStatistics statistics_of(const std::vector<double>& row) {
    Image<double> image(static_cast<int>(row.size()), 1);
    for (std::size_t i = 0; i < row.size(); ++i) image.pixels()[i] = row[i];
    return difference_statistics(std::as_const(image).view());
}

// Of 1 to n in any order, by nearest rank: ceil(n / 2) and ceil(0.99 n).
TEST(DifferenceStatistics, PercentilesAreValuesByNearestRank) {
    for (const int n : {1, 2, 3, 10, 99, 100, 101, 200, 1000, 1001}) {
        std::vector<double> values;
        for (int i = 0; i < n; ++i) values.push_back(1.0 + (i * 7919 + 13) % n);  // 7919 is prime: each number once
        const DifferenceStatistics found = statistics_of(values);
        EXPECT_EQ(found.p50, (n + 1) / 2) << n;
        EXPECT_EQ(found.p99, (99 * n + 99) / 100) << n;
        EXPECT_EQ(found.max, n);
        EXPECT_DOUBLE_EQ(found.mean, 0.5 * (n + 1)) << n;
        EXPECT_EQ(found.pixels, n);
    }
}

TEST(DifferenceStatistics, PixelsWithoutADifferenceAreLeftOut) {
    EXPECT_EQ(statistics_of({kNaN, 2.0, kNaN, 4.0, 3.0}),
              (DifferenceStatistics{.pixels = 3, .mean = 3.0, .p50 = 3.0, .p99 = 4.0, .max = 4.0, .max_x = 3}));
    EXPECT_EQ(statistics_of({kNaN, kNaN}), DifferenceStatistics{});
}

TEST(DifferenceStatistics, TheFirstOfTheLargestIsNamed) {
    Image<double> image(4, 3);
    image(2, 1) = image(1, 2) = 5.0;
    const DifferenceStatistics found = difference_statistics(std::as_const(image).view());
    EXPECT_EQ(std::pair(found.max_x, found.max_y), std::pair(2, 1));
    EXPECT_EQ(found.p50, 0.0);
}

}  // namespace
}  // namespace emulsion
