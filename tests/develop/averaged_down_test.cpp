#include "develop/averaged_down.h"

#include <optional>
#include <utility>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

std::optional<XYZ> positive(const XYZ& pixel) { return pixel.y > 0.0f ? std::optional(pixel) : std::nullopt; }

TEST(AveragedDown, SizesKeepTheirProportion) {
    EXPECT_EQ(size_within(1000, 500, 256), std::pair(256, 128));
    EXPECT_EQ(size_within(500, 1000, 256), std::pair(128, 256));
    EXPECT_EQ(size_within(200, 100, 256), std::pair(200, 100)) << "never enlarged";
    EXPECT_EQ(size_within(10000, 3, 256), std::pair(256, 1)) << "at least 1";
}

// Five columns on two: the first two, and the other three.
TEST(AveragedDown, EachPixelIsTheMeanOfItsBlock) {
    Image<XYZ> picture(5, 2);
    for (int x = 0; x < 5; ++x) picture(x, 0) = picture(x, 1) = XYZ{1.0f, static_cast<float>(x + 1), 2.0f};
    picture(4, 1).y = 8.0f;
    const Image<XYZ> smaller = averaged_down(picture, 2, 1, 1, positive);
    EXPECT_EQ(smaller(0, 0), (XYZ{1.0f, 1.5f, 2.0f}));
    EXPECT_EQ(smaller(1, 0), (XYZ{1.0f, 4.5f, 2.0f}));
}

TEST(AveragedDown, WhatIsLeftOutDoesNotCount) {
    Image<XYZ> picture(4, 2);
    picture(0, 0) = picture(1, 1) = {3.0f, 3.0f, 3.0f};
    picture(1, 0).y = -9.0f;
    const Image<XYZ> smaller = averaged_down(picture, 2, 1, 4, positive);
    EXPECT_EQ(smaller(0, 0), (XYZ{3.0f, 3.0f, 3.0f}));
    EXPECT_EQ(smaller(1, 0), XYZ{}) << "nothing is left";
}

}  // namespace
}  // namespace emulsion
