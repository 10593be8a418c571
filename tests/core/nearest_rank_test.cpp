#include "core/nearest_rank.h"

#include <vector>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

// Of 1 to n in any order: ceil(n percent / 100).
TEST(NearestRank, IsTheLeastValueThatSoManyDoNotExceed) {
    for (const int n : {1, 2, 3, 10, 99, 100, 101, 200, 700, 1001}) {
        std::vector<double> values;
        for (int i = 0; i < n; ++i) values.push_back(1.0 + (i * 7919 + 13) % n);  // 7919 is prime: each number once
        for (const int percent : {1, 50, 99, 100}) {
            EXPECT_EQ(nearest_rank(values, percent), (percent * n + 99) / 100) << n << " " << percent;
        }
    }
}

TEST(NearestRank, OfNothingIsZero) { EXPECT_EQ(nearest_rank({}, 99), 0.0); }

}  // namespace
}  // namespace emulsion
