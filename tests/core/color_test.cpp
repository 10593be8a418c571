#include "core/color.h"

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(Color, AddsAndScalesComponentByComponent) {
    EXPECT_EQ((XYZ{1, 2, 3} + XYZ{10, 20, 30}), (XYZ{11, 22, 33}));
    EXPECT_EQ(2.0f * (XYZ{1, 2, 3}), (XYZ{2, 4, 6}));
    EXPECT_EQ((RGBd{1, 2, 3} + RGBd{10, 20, 30}), (RGBd{11, 22, 33}));
    EXPECT_EQ(0.5 * (RGBd{1, 2, 3}), (RGBd{0.5, 1, 1.5}));
}

TEST(Color, StartsBlack) {
    EXPECT_EQ(XYZ{}, (XYZ{0, 0, 0}));
    EXPECT_EQ(RGBd{}, (RGBd{0, 0, 0}));
}

}  // namespace
}  // namespace emulsion
