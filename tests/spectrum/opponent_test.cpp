#include "spectrum/opponent.h"

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(Opponent, IsTheSumAndTwoDifferences) {
    EXPECT_EQ(opponent_from_rgb({1.0, 2.0, 4.0}), (Opponent{7.0, -1.0, -1.0}));
    EXPECT_EQ(rgb_from_opponent({7.0, -1.0, -1.0}), (RGBd{1.0, 2.0, 4.0}));
}

TEST(Opponent, OfWhiteIsNotNeutralInYellowAndBlue) {
    EXPECT_EQ(opponent_from_rgb({1.0, 1.0, 1.0}), (Opponent{3.0, 1.0, 0.0}));
}

TEST(Opponent, TakesNegativeValues) {
    EXPECT_EQ(rgb_from_opponent(opponent_from_rgb({-0.5, 1.5, -2.0})), (RGBd{-0.5, 1.5, -2.0}));
}

}  // namespace
}  // namespace emulsion
