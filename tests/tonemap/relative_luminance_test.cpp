#include "tonemap/relative_luminance.h"

#include <limits>

#include <gtest/gtest.h>

#include "test_pictures.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

template <class T = double>
Image<T> relative(const Image<XYZ>& scene, int threads = 1) {
    return relative_luminance<T>(scene.view(), SceneLuminance(scene.view(), threads), threads);
}

TEST(RelativeLuminance, IsRelativeToTheLogAverage) {
    const Image<double> result = relative(row_of_greys({2.0f, 8.0f, 0.0f}));
    EXPECT_DOUBLE_EQ(result(0, 0), 0.5);
    EXPECT_DOUBLE_EQ(result(1, 0), 2.0);
    EXPECT_EQ(result(2, 0), 0.0);
}

// The eight about the centre: 1 to 8, between 4 and 5 in the middle. Their log-average is 8!^(1/8).
TEST(RelativeLuminance, BadPixelHasTheMedianOfItsNeighbours) {
    for (const float bad : {kNan, kInf, -5.0f}) {
        Image<XYZ> scene(3, 3);
        for (int i = 0; i < 9; ++i)
            scene.pixels()[static_cast<std::size_t>(i)] = grey(static_cast<float>(i < 4 ? i + 1 : i));
        scene(1, 1) = grey(bad);
        EXPECT_NEAR(relative(scene)(1, 1), std::sqrt(20.0) / std::pow(40320.0, 0.125), 1e-12) << bad;
    }
}

TEST(RelativeLuminance, MedianIsOfGoodNeighboursOnly) {
    const Image<double> result = relative(row_of_greys({4.0f, kNan, kNan, kNan, 16.0f}));  // log-average 8
    EXPECT_DOUBLE_EQ(result(1, 0), 0.5);                                                   // 4 alone
    EXPECT_DOUBLE_EQ(result(2, 0), 1.0);                                                   // 4 and 16, two away
    EXPECT_DOUBLE_EQ(result(3, 0), 2.0);
}

// Luminance rises from row to row; only the two beside a pixel of the first row lie opposite each other.
TEST(RelativeLuminance, BadPixelAtTheEdgeHasTheMedianOfOppositeNeighbours) {
    Image<XYZ> scene(5, 5);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 5; ++x) scene(x, y) = grey(std::exp2(static_cast<float>(y)));
    }
    scene(2, 0) = grey(kNan);
    scene(2, 3) = grey(kNan);
    const Image<double> result = relative(scene);
    EXPECT_NEAR(result(2, 0) / result(0, 0), 1.0, 1e-12);
    EXPECT_NEAR(result(2, 3) / result(0, 3), 1.0, 1e-12);
}

TEST(RelativeLuminance, FarFromAnyGoodPixelItIsOne) {
    Image<XYZ> scene(11, 1);
    for (XYZ& pixel : scene.pixels()) pixel = grey(kNan);
    scene(0, 0) = grey(5.0f);
    const Image<double> result = relative(scene);
    EXPECT_DOUBLE_EQ(result(4, 0), 1.0);  // of the pixel at 0
    EXPECT_DOUBLE_EQ(result(10, 0), 1.0);
    scene(1, 0) = grey(20.0f);  // log-average 10
    EXPECT_DOUBLE_EQ(relative(scene)(4, 0), 2.0);
    EXPECT_DOUBLE_EQ(relative(scene)(5, 0), 2.0);
    EXPECT_DOUBLE_EQ(relative(scene)(6, 0), 1.0);
}

TEST(RelativeLuminance, OutlierHasTheMedianOfItsNeighbours) {
    Image<XYZ> scene(9, 9);
    for (XYZ& pixel : scene.pixels()) pixel = grey(3.0f);
    scene(4, 4) = grey(1e30f);
    const SceneLuminance luminance = SceneLuminance(scene.view(), 1);
    EXPECT_LT(luminance.least_outlier_cdm2(), 3.2e3);
    const Image<double> result = relative(scene);
    EXPECT_DOUBLE_EQ(result(4, 4), result(0, 0));
    scene(4, 4) = grey(2e3f);  // not quite
    EXPECT_DOUBLE_EQ(relative(scene)(4, 4) / relative(scene)(0, 0), 2e3 / 3.0);
}

// Of fewer than 64 pixels none is an outlier.
TEST(RelativeLuminance, StaysBelowItsLimit) {
    const Image<float> result = relative<float>(row_of_greys({1e-38f, 1e-38f, 1e-38f, 3e38f}));
    EXPECT_LT(result(3, 0), 0x1p120f);
    EXPECT_GT(result(3, 0), 0x1p118f);
}

TEST(RelativeLuminance, SameBitsForEveryNumberOfThreads) {
    Image<XYZ> scene = random_scene(211, 97, 7);
    for (int x = 0; x < 211; x += 5) scene(x, x % 97) = grey(kNan);
    const Image<float> one = relative<float>(scene, 1);
    for (const int threads : {2, 3, 8, 0}) EXPECT_EQ(relative<float>(scene, threads), one) << threads;
}

}  // namespace
}  // namespace emulsion
