#include "tonemap/bloom.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "test_pictures.h"
#include "tonemap/axis_halving.h"

namespace emulsion {
namespace {

struct Sums {
    double x = 0.0, y = 0.0, z = 0.0, magnitudes = 0.0;
};

template <class Pixel>
Sums sums_of(const Image<Pixel>& picture) {
    Sums sums;
    for (const Pixel& pixel : picture.pixels()) {
        sums.x += pixel.x;
        sums.y += pixel.y;
        sums.z += pixel.z;
        sums.magnitudes += std::abs(pixel.x) + std::abs(pixel.y) + std::abs(pixel.z);
    }
    return sums;
}

void expect_same_sums(const Sums& found, const Sums& expected, double relative) {
    EXPECT_NEAR(found.x, expected.x, relative * expected.magnitudes);
    EXPECT_NEAR(found.y, expected.y, relative * expected.magnitudes);
    EXPECT_NEAR(found.z, expected.z, relative * expected.magnitudes);
}

// The kernel over its own sum, by hand.
TEST(Bloom, TwinMakesOneBrightPixelTheKernel) {
    constexpr double kRadius = 6.1;
    Image<XYZ> scene(31, 29);
    scene(15, 14) = {1.0f, 2.0f, 3.0f};
    double sum = 0.0;
    for (int y = -7; y <= 7; ++y) {
        for (int x = -7; x <= 7; ++x) sum += std::pow(std::max(0.0, 1.0 - std::hypot(x, y) / kRadius), 4.0);
    }
    const auto radius = static_cast<float>(kRadius / 31.0);
    const Image<XYZd> result = add_bloom_reference(QuarticBloom{radius, 0.25f}, scene.view());
    for (int y = 0; y < 29; ++y) {
        for (int x = 0; x < 31; ++x) {
            const double d = std::hypot(x - 15, y - 14) / kRadius;
            const double kernel = 0.25 * std::pow(std::max(0.0, 1.0 - d), 4.0) / sum + (d == 0.0 ? 0.75 : 0.0);
            EXPECT_NEAR(result(x, y).y, 2.0 * kernel, 1e-6);  // the radius is a float
            EXPECT_NEAR(result(x, y).z, 3.0 * kernel, 1e-6);
        }
    }
}

// The stated tolerance: 5 % of the kernel's peak, 2 % of the light in all, for radii on all levels and at edges.
TEST(Bloom, OneBrightPixelComesCloseToTheTwin) {
    for (const auto& [width, height, px, py] : {std::tuple{61, 53, 30, 26},
                                                {61, 53, 0, 0},
                                                {32, 32, 31, 10},
                                                {1, 101, 0, 7},
                                                {101, 1, 50, 0},
                                                {3, 2, 1, 1}}) {
        Image<XYZ> scene(width, height);
        scene(px, py) = grey(1.0f);
        for (const float radius_px : {0.5f, 1.0f, 1.2f, 2.0f, 3.0f, 5.0f, 8.0f, 13.0f, 21.0f, 34.0f, 61.0f}) {
            const float radius = std::min(1.0f, radius_px / static_cast<float>(std::max(width, height)));
            const Image<XYZ> fast = add_bloom(QuarticBloom{radius, 1.0f}, scene.view(), 1);
            const Image<XYZd> exact = add_bloom_reference(QuarticBloom{radius, 1.0f}, scene.view());
            double peak = 0.0, largest = 0.0, misplaced = 0.0;
            for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
                const double difference = std::abs(fast.pixels()[i].y - exact.pixels()[i].y);
                peak = std::max(peak, exact.pixels()[i].y);
                largest = std::max(largest, difference);
                misplaced += 0.5 * difference;
            }
            EXPECT_LE(largest, 0.05 * peak) << width << "x" << height << ", radius " << radius_px;
            EXPECT_LE(misplaced, 0.02) << width << "x" << height << ", radius " << radius_px;
            EXPECT_NEAR(sums_of(fast).y, 1.0, 1e-6);
        }
    }
}

TEST(Bloom, RandomScenesComeCloseToTheTwin) {
    Image<XYZ> scene = random_scene(61, 43, 31);
    scene(10, 11).y = -1.0f;  // bad
    const QuarticBloom bloom{0.3f, 0.3f};
    const Image<XYZ> fast = add_bloom(bloom, scene.view(), 1);
    const Image<XYZd> exact = add_bloom_reference(bloom, scene.view());
    // Twice the misplaced share of what spreads, times the brightest light that does.
    for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
        EXPECT_NEAR(fast.pixels()[i].y, exact.pixels()[i].y, 2.0 * 0.02 * 0.3 * 1000.0);
    }
    EXPECT_EQ(fast(10, 11), scene(10, 11));
}

TEST(Bloom, ConservesLightAlsoAtEdgesAndBesideBadPixels) {
    for (const auto& [width, height] : {std::pair{64, 64}, {101, 97}, {127, 3}, {1, 1009}, {1009, 1}, {2, 2}}) {
        for (const float radius : {0.001f, 0.01f, 0.03f, 0.1f, 0.5f, 1.0f}) {
            Image<XYZ> scene = random_scene(width, height, 32);
            expect_same_sums(sums_of(add_bloom(QuarticBloom{radius, 1.0f}, scene.view(), 1)), sums_of(scene), 1e-6);
            scene(width / 2, height / 2) = {3.0f, -5.0f, 4.0f};
            expect_same_sums(sums_of(add_bloom(QuarticBloom{radius, 1.0f}, scene.view(), 1)), sums_of(scene), 1e-6);
        }
    }
    Image<XYZ> scene = random_scene(23, 19, 33);
    scene(0, 0).y = -1.0f;
    expect_same_sums(sums_of(add_bloom_reference(QuarticBloom{0.4f, 1.0f}, scene.view())), sums_of(scene), 1e-12);
}

TEST(Bloom, RadiusOfUpToAPixelOrNoWeightChangesNothing) {
    const Image<XYZ> scene = random_scene(100, 50, 34);
    EXPECT_EQ(add_bloom(QuarticBloom{0.01f, 1.0f}, scene.view(), 1), scene);
    EXPECT_EQ(add_bloom(QuarticBloom{0.0f, 1.0f}, scene.view(), 1), scene);
    EXPECT_EQ(add_bloom(QuarticBloom{0.5f, 0.0f}, scene.view(), 1), scene);
    EXPECT_EQ(add_bloom(NoBloom{}, scene.view(), 1), scene);
    EXPECT_NE(add_bloom(QuarticBloom{0.011f, 1.0f}, scene.view(), 1), scene);
}

TEST(Bloom, DoesNotDependOnTheUnit) {
    const Image<XYZ> scene = random_scene(64, 48, 35);
    const Image<XYZ> bloomed = add_bloom(QuarticBloom{}, scene.view(), 1);
    Image<XYZ> other = scene;
    for (XYZ& pixel : other.pixels()) pixel = 0x1p-40f * pixel;  // about 1e-12, exact
    const Image<XYZ> of_other = add_bloom(QuarticBloom{}, other.view(), 1);
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
        EXPECT_EQ(of_other.pixels()[i], 0x1p-40f * bloomed.pixels()[i]);
    }
}

TEST(Bloom, RejectsParametersOutOfRange) {
    EXPECT_THROW((void)add_bloom(QuarticBloom{1.5f, 0.1f}, Image<XYZ>(2, 2).view(), 1), std::invalid_argument);
    EXPECT_THROW((void)add_bloom(QuarticBloom{0.1f, -0.1f}, Image<XYZ>(2, 2).view(), 1), std::invalid_argument);
    EXPECT_THROW((void)add_bloom(QuarticBloom{}, Image<XYZ>(2, 2).view(), -1), std::invalid_argument);
}

TEST(AxisHalving, WeightsKeepConstantsAndSums) {
    for (int size = 1; size <= 300; ++size) {
        const AxisHalving axis(size);
        std::vector<double> of_full(static_cast<std::size_t>(size));
        for (int j = 0; j < axis.half_size(); ++j) {
            double sum = 0.0;
            for (int k = 0; k < axis.down(j).count; ++k) {
                const double weight = axis.down(j).weights[static_cast<std::size_t>(k)];
                EXPECT_GE(weight, 0.0);
                sum += weight;
                of_full[static_cast<std::size_t>(axis.down(j).first + k)] += weight * axis.spacing();
            }
            EXPECT_NEAR(sum, 1.0, 2e-7);
        }
        for (int i = 0; i < size; ++i) {
            double sum = 0.0;
            for (int k = 0; k < axis.up(i).count; ++k) sum += axis.up(i).weights[static_cast<std::size_t>(k)];
            EXPECT_NEAR(sum, 1.0, 2e-7);
            EXPECT_NEAR(of_full[static_cast<std::size_t>(i)], 1.0, 2e-7);
        }
    }
}

}  // namespace
}  // namespace emulsion
