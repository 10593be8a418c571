#include "tonemap/luminance_statistics.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "core/random.h"
#include "test_pictures.h"
#include "tonemap/scene_luminance.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

LuminanceStatistics of(const Image<XYZ>& scene, int threads = 1) { return luminance_statistics(scene.view(), threads); }

TEST(LuminanceStatistics, PowersOfTwoHaveTheirGeometricMean) {
    Image<XYZ> scene(3, 1);
    scene(0, 0) = grey(2.0f);
    scene(1, 0) = grey(4.0f);
    scene(2, 0) = grey(8.0f);
    const LuminanceStatistics statistics = of(scene);
    EXPECT_DOUBLE_EQ(statistics.log_average_cdm2, 4.0);
    EXPECT_EQ(statistics.min_positive_cdm2, 2.0);
    EXPECT_EQ(statistics.max_cdm2, 8.0);
    EXPECT_EQ(statistics.counts.positive, 3);
    EXPECT_FALSE(statistics.first_bad_px.has_value());
}

// A running sum in single precision gives 14.5 for 8 megapixels of 20 cd/m^2.
TEST(LuminanceStatistics, ManyEqualPixelsAverageToTheirValue) {
    Image<XYZ> scene(4096, 2048);
    for (XYZ& pixel : scene.pixels()) pixel = grey(20.0f);
    EXPECT_NEAR(of(scene, 0).log_average_cdm2, 20.0, 20.0 * 1e-12);
}

TEST(LuminanceStatistics, ZerosAreCountedAndLeftOut) {
    Image<XYZ> scene(4, 1);
    scene(0, 0) = grey(2.0f);
    scene(3, 0) = grey(8.0f);
    scene(1, 0).y = -0.0f;
    const LuminanceStatistics statistics = of(scene);
    EXPECT_DOUBLE_EQ(statistics.log_average_cdm2, 4.0);
    EXPECT_EQ(statistics.counts.zero, 2);
    EXPECT_EQ(statistics.min_positive_cdm2, 2.0);
    EXPECT_FALSE(statistics.first_bad_px.has_value());
}

TEST(LuminanceStatistics, BadPixelsAreCountedAndTheFirstIsNamed) {
    Image<XYZ> scene(3, 3);
    for (XYZ& pixel : scene.pixels()) pixel = grey(5.0f);
    scene(2, 1) = {kNan, 5.0f, 5.0f};
    scene(1, 1) = {5.0f, -1.0f, 5.0f};
    scene(0, 2) = {5.0f, 5.0f, kInf};
    scene(1, 2) = {5.0f, -kInf, 5.0f};
    scene(2, 2) = {kInf, kNan, -1.0f};
    const LuminanceStatistics statistics = of(scene);
    EXPECT_EQ(statistics.counts, (PixelCounts{4, 0, 2, 2, 1}));
    EXPECT_EQ(statistics.counts.bad(), 5);
    EXPECT_EQ(statistics.first_bad_px, std::make_pair(1, 1));
    EXPECT_NEAR(statistics.log_average_cdm2, 5.0, 1e-14);
}

TEST(LuminanceStatistics, NegativeXAndZAreColoursNotErrors) {
    EXPECT_EQ(classify({-1.0f, 1.0f, -1.0f}), PixelClass::positive);
    EXPECT_EQ(classify({-1.0f, 0.0f, -1.0f}), PixelClass::zero);
    EXPECT_EQ(classify({-kInf, 1.0f, 0.0f}), PixelClass::infinite);
}

TEST(LuminanceStatistics, WithoutPositivePixelsEverythingIsZero) {
    const LuminanceStatistics statistics = of(Image<XYZ>(5, 4));
    EXPECT_EQ(statistics.log_average_cdm2, 0.0);
    EXPECT_EQ(statistics.min_positive_cdm2, 0.0);
    EXPECT_EQ(statistics.max_cdm2, 0.0);
    EXPECT_EQ(statistics.counts, (PixelCounts{0, 20, 0, 0, 0}));
    EXPECT_EQ(luminance_statistics_reference(Image<XYZ>(5, 4).view()), statistics);
}

// Every float that is not bad, denormals included, as bit patterns.
TEST(LuminanceStatistics, AgreesWithItsTwinOverTheWholeRange) {
    Pcg32 random(1);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 3001}, {3001, 1}, {257, 263}, {20000, 3}}) {
        Image<XYZ> scene(width, height);
        for (XYZ& pixel : scene.pixels()) pixel = grey(std::bit_cast<float>(random.next() % 0x7f800000u));
        const LuminanceStatistics fast = of(scene, 0);
        const LuminanceStatistics exact = luminance_statistics_reference(scene.view());
        EXPECT_NEAR(fast.log_average_cdm2 / exact.log_average_cdm2, 1.0, 1e-12) << width << "x" << height;
        EXPECT_EQ(fast.min_positive_cdm2, exact.min_positive_cdm2);
        EXPECT_EQ(fast.max_cdm2, exact.max_cdm2);
        EXPECT_EQ(fast.counts, exact.counts);
    }
}

TEST(LuminanceStatistics, SameBitsForEveryNumberOfThreads) {
    const Image<XYZ> scene = random_scene(1021, 509, 3);
    const LuminanceStatistics one = of(scene, 1);
    for (const int threads : {2, 3, 8, 0}) EXPECT_EQ(of(scene, threads), one) << threads;
}

// Of pictures of more than 2^19 pixels every fourth group of 16 in a row, the first in turn 0, 2, 1, 3.
TEST(LuminanceStatistics, HistogramCountsTheGroupsThatItSays) {
    for (const auto& [width, height] : {std::pair{731, 717}, {1021, 600}, {40, 14000}}) {
        Image<XYZ> scene = random_scene(width, height, 5);
        for (std::size_t i = 0; i < scene.pixels().size(); i += 7) scene.pixels()[i] = {};
        for (std::size_t i = 0; i < scene.pixels().size(); i += 101) scene.pixels()[i].y = -1.0f;
        for (std::size_t i = 3; i < scene.pixels().size(); i += 103) scene.pixels()[i].x = kNan;
        for (std::size_t i = 5; i < scene.pixels().size(); i += 107) scene.pixels()[i].y = 1e-40f;
        const bool all = scene.pixels().size() <= std::size_t{1} << 19u;
        LuminanceHistogram expected;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool counted = all || x / 16 % 4 == std::array{0, 2, 1, 3}[static_cast<std::size_t>(y % 4)];
                if (counted && classify(scene(x, y)) == PixelClass::positive) expected.add(scene(x, y).y);
            }
        }
        for (const int threads : {1, 3, 0}) {
            EXPECT_EQ(SceneLuminance(scene.view(), threads).histogram(), expected) << width << ' ' << threads;
        }
    }
}

// One pixel of 64 to 1999 at each end, one thousandth of more; those far beyond are left out before.
TEST(LuminanceStatistics, RobustEndsLeaveOutliersOut) {
    for (const int count : {64, 81, 1999, 2000, 5000}) {
        Image<XYZ> scene = ramp_of_greys(1.0, 100.0, count);
        const int outliers = std::max(1, count / 1000);
        for (int i = 0; i < outliers; ++i) {
            scene(i, 0) = grey(1e-30f);
            scene(count - 1 - i, 0) = grey(1e30f);
        }
        const SceneLuminance luminance = SceneLuminance(scene.view(), 1);
        EXPECT_NEAR(luminance.robust_min_cdm2() / double{scene(2 * outliers, 0).y}, 1.0, 1.0 / 32.0) << count;
        EXPECT_NEAR(luminance.robust_max_cdm2() / double{scene(count - 1 - 2 * outliers, 0).y}, 1.0, 1.0 / 32.0)
            << count;
    }
}

// Ten suns in 10,000 pixels, just as many as are left out: so it stays when another pixel goes bad, or far beyond them.
TEST(LuminanceStatistics, RobustEndsStayWhenOnePixelChanges) {
    Image<XYZ> scene(100, 100);
    for (int i = 0; i < 10000; ++i)
        scene.pixels()[static_cast<std::size_t>(i)] = grey(1.0f + 1e-4f * static_cast<float>(i));
    for (int x = 0; x < 10; ++x) scene(x, 50) = grey(1e4f);
    const SceneLuminance before(scene.view(), 1);
    for (const float value : {kNan, kInf, -1.0f, 1e30f, 1e-30f}) {
        scene(3, 70) = grey(value);
        const SceneLuminance after(scene.view(), 1);
        EXPECT_NEAR(after.robust_max_cdm2() / before.robust_max_cdm2(), 1.0, 1e-3) << value;
        EXPECT_NEAR(after.robust_min_cdm2() / before.robust_min_cdm2(), 1.0, 1e-3) << value;
    }
}

TEST(LuminanceStatistics, SmallPicturesHaveNoOutliers) {
    Image<XYZ> scene = ramp_of_greys(1.0, 100.0, 63);
    scene(0, 0) = grey(1e-30f);
    scene(1, 0) = grey(1e30f);
    const SceneLuminance luminance = SceneLuminance(scene.view(), 1);
    EXPECT_EQ(luminance.robust_min_cdm2(), double{1e-30f});
    EXPECT_EQ(luminance.robust_max_cdm2(), double{1e30f});
    EXPECT_EQ(SceneLuminance(Image<XYZ>(9, 9).view(), 1).robust_max_cdm2(), 0.0);
}

TEST(LuminanceStatistics, ScalesWithTheUnit) {
    Image<XYZ> scene = random_scene(64, 64, 4);
    scene(5, 5) = {};
    const LuminanceStatistics before = of(scene);
    for (XYZ& pixel : scene.pixels()) pixel = 0x1p-40f * pixel;
    EXPECT_NEAR(of(scene).log_average_cdm2 / (0x1p-40 * before.log_average_cdm2), 1.0, 1e-12);
}

// Where the darkest pixels have a hundred steps left, half a one is half a hundredth.
TEST(SceneLuminance, RobustEndsScaleWithThePictureDownToDenormals) {
    const Image<XYZ> scene = ramp_of_greys(1.0, 100.0, 5000);
    const SceneLuminance before(scene.view(), 1);
    for (const float factor : {1e-36f, 1e-37f, 1e-38f, 1e-39f, 1e-40f, 1e-41f, 1.5e-43f}) {
        Image<XYZ> other = scene;
        for (XYZ& pixel : other.pixels()) pixel = factor * pixel;
        const SceneLuminance after(other.view(), 1);
        const double exact = factor;
        EXPECT_NEAR(after.robust_min_cdm2() / (exact * before.robust_min_cdm2()), 1.0, 0.031) << factor;
        EXPECT_NEAR(after.robust_max_cdm2() / (exact * before.robust_max_cdm2()), 1.0, 0.031) << factor;
        EXPECT_NEAR(after.log_average_cdm2() / (exact * before.log_average_cdm2()), 1.0, 1e-3) << factor;
    }
}

}  // namespace
}  // namespace emulsion
