#include "tonemap/vision.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/random.h"
#include "test_pictures.h"
#include "tonemap/acuity.h"
#include "tonemap/rod_vision.h"
#include "tonemap/veiling_glare.h"

namespace emulsion {
namespace {

constexpr HumanVision kNoGlare{.glare = 0.0f};

/// Squares of two greys, with noise.
Image<XYZ> checkered(int width, int height, float luminance_cdm2, unsigned seed) {
    Pcg32 random(seed);
    Image<XYZ> scene(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float square = (x / 6 + y / 6) % 2 == 0 ? 1.0f : 0.5f;
            scene(x, y) = grey(luminance_cdm2 * square * (0.9f + 0.2f * random.next_float()));
        }
    }
    return scene;
}

TEST(RodVision, ScotopicLuminanceFollowsTheFit) {
    EXPECT_NEAR(scotopic_luminance({1.0, 1.0, 1.0}), 2.31, 1e-12);
    EXPECT_NEAR(scotopic_luminance({0.5, 2.0, 1.0}), 2.0 * (1.33 * 7.0 - 1.68), 1e-12);
    EXPECT_EQ(scotopic_luminance({1.0, 1.0, -0.9}), 0.0);
    EXPECT_EQ(scotopic_luminance({0.0, 2.0, 1.0}), 20.0);
    EXPECT_EQ(scotopic_luminance({-1.0, 2.0, 1.0}), 20.0);
    EXPECT_EQ(scotopic_luminance({1e-30, 2.0, 1.0}), 20.0);
}

TEST(RodVision, ConesTakeOverThroughTheMesopicRange) {
    EXPECT_EQ(cone_share(0.0), 0.0);
    EXPECT_EQ(cone_share(0.0056), 0.0);
    EXPECT_NEAR(cone_share(0.5 * (0.0056 + 5.6)), 0.5, 1e-12);
    EXPECT_EQ(cone_share(5.6), 1.0);
    EXPECT_EQ(cone_share(1e30), 1.0);
}

// Scotopic: whatever the colour was, one bluish white, of the scotopic luminance over that of white.
TEST(Vision, DarkSceneGoesGreyBlue) {
    Image<XYZ> scene(40, 30);
    for (XYZ& pixel : scene.pixels()) pixel = {0.002f, 0.001f, 0.0001f};  // reddish
    const Image<XYZ> seen = see(HumanVision{}, scene.view(), 1);
    const double grey = 0.001 * (1.33 * (1.0 + 0.0011 / 0.002) - 1.68) / 2.31;
    for (const XYZ& pixel : seen.pixels()) {
        EXPECT_NEAR(pixel.x, grey, 1e-5 * grey);
        EXPECT_NEAR(pixel.y, grey, 1e-5 * grey);
        EXPECT_NEAR(pixel.z, 2.0 * grey, 1e-5 * grey);
    }
    const Image<XYZ> unshifted = see(HumanVision{.blue = 0.0f}, scene.view(), 1);
    EXPECT_NEAR(unshifted(0, 0).z, grey, 1e-5 * grey);
}

TEST(Vision, PhotopicSceneStaysAsItIs) {
    Image<XYZ> scene = random_scene(97, 61, 41);
    for (XYZ& pixel : scene.pixels()) pixel = (6.0f / 1e-3f) * pixel;  // all above 5.6 cd/m^2
    EXPECT_EQ(see(kNoGlare, scene.view(), 1), scene);
}

TEST(Vision, EveryPartCanBeSwitchedOff) {
    const Image<XYZ> scene = checkered(40, 30, 1e-2f, 42);
    EXPECT_EQ(see(HumanVision{.glare = 0.0f, .acuity = 0.0f, .rods = 0.0f}, scene.view(), 1), scene);
    EXPECT_EQ(see(NoVision{}, scene.view(), 1), scene);
    for (const HumanVision& part : {HumanVision{.glare = 1.0f, .acuity = 0.0f, .rods = 0.0f},
                                    HumanVision{.fov = 5.0f, .glare = 0.0f, .acuity = 1.0f, .rods = 0.0f},
                                    HumanVision{.glare = 0.0f, .acuity = 0.0f, .rods = 1.0f}}) {
        EXPECT_NE(see(part, scene.view(), 1), scene);
    }
}

TEST(Acuity, FrequencyFollowsTheFit) {
    EXPECT_NEAR(highest_visible_frequency(1.0), 17.25 * std::atan(0.35) + 25.72, 1e-12);
    EXPECT_NEAR(highest_visible_frequency(1000.0), 17.25 * std::atan(4.55) + 25.72, 1e-12);
    EXPECT_EQ(highest_visible_frequency(0.0), highest_visible_frequency(1e-5));
    EXPECT_GT(highest_visible_frequency(0.0), 1.0);
}

// What is left of a grating's contrast, relative to what an eye in brighter light has: 5 % over its own.
TEST(Acuity, BlurTakesTheContrastOfWhatCannotBeSeen) {
    const auto contrast = [](double sigma, double frequency) {
        return std::exp(-2.0 * std::pow(std::numbers::pi * sigma * frequency, 2.0));
    };
    EXPECT_EQ(acuity_blur_degrees(5.6), 0.0);
    const double frequency = highest_visible_frequency(0.01);
    const double relative = std::pow(0.05, 1.0 - std::pow(frequency / highest_visible_frequency(5.6), 2.0));
    EXPECT_NEAR(contrast(acuity_blur_degrees(0.01), frequency), relative, 1e-9);
    for (double cdm2 = 1e-6; cdm2 < 10.0; cdm2 *= 1.5) {
        EXPECT_GE(acuity_blur_degrees(cdm2), acuity_blur_degrees(1.5 * cdm2)) << cdm2;
    }
}

// Interpolation between levels is no Gaussian: what the pyramid costs, as shares of the squares' luminance.
TEST(Acuity, ComesCloseToTheTwin) {
    for (const float luminance_cdm2 : {1e-4f, 1e-2f, 1.0f}) {
        Image<XYZ> scene = checkered(67, 53, luminance_cdm2, 43);
        scene(30, 20).y = -1.0f;  // bad
        for (const float fov : {10.0f, 20.0f, 50.0f}) {
            const HumanVision vision{.fov = fov, .glare = 0.0f, .rods = 0.0f};
            const Image<XYZ> fast = see(vision, scene.view(), 1);
            const Image<XYZd> exact = see_reference(vision, scene.view());
            double sum = 0.0;
            for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
                const double difference = std::abs(fast.pixels()[i].y - exact.pixels()[i].y) / luminance_cdm2;
                EXPECT_LE(difference, 0.2) << fov;
                sum += difference;
            }
            EXPECT_LE(sum / static_cast<double>(fast.pixels().size()), 0.05) << luminance_cdm2 << ", " << fov;
        }
    }
}

TEST(VeilingGlare, KernelFallsAsTheSquareOfTheAngle) {
    const auto at = [](double degrees) { return veil_kernel(std::tan(degrees * std::numbers::pi / 180.0)); };
    EXPECT_NEAR(at(5.0) / at(10.0),
                4.0 * std::pow(std::cos(std::numbers::pi / 36.0) / std::cos(std::numbers::pi / 18.0), 4.0), 0.04);
    EXPECT_NEAR(at(0.0) / at(0.5), 2.0, 1e-3);
}

// The stated tolerance: 3 % of the scattered light falls elsewhere.
TEST(VeilingGlare, OneBrightPixelComesCloseToTheTwin) {
    Image<XYZ> scene(61, 47);
    scene(20, 30) = grey(1.0f);
    for (const double tangent_per_px : {0.02, 0.03, 0.1}) {
        const Image<XYZ> fast = add_veil(scene.view(), 1.0, tangent_per_px, 1);
        const Image<XYZd> exact = add_veil_reference(scene.view(), 1.0, tangent_per_px);
        double misplaced = 0.0, sum = 0.0;
        for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
            misplaced += 0.5 * std::abs(fast.pixels()[i].y - exact.pixels()[i].y);
            sum += fast.pixels()[i].y;
        }
        EXPECT_LE(misplaced, 0.03) << tangent_per_px;
        EXPECT_NEAR(sum, 1.0, 1e-6);
    }
}

TEST(VeilingGlare, ShareOfALampLiesOverTheDark) {
    Image<XYZ> scene(61, 47);
    scene(30, 23) = grey(1e5f);
    const Image<XYZ> seen = see(HumanVision{}, scene.view(), 1);
    EXPECT_GT(seen(0, 0).y, 0.1f);
    EXPECT_GT(seen(28, 23).y, seen(20, 23).y);
    EXPECT_NEAR(seen(30, 23).y, 1e5 * 0.95, 1e5 * 0.045);
}

TEST(Vision, RejectsParametersOutOfRange) {
    EXPECT_THROW((void)see(HumanVision{.fov = 0.5f}, Image<XYZ>(2, 2).view(), 1), std::invalid_argument);
    EXPECT_THROW((void)see(HumanVision{.rods = 2.0f}, Image<XYZ>(2, 2).view(), 1), std::invalid_argument);
    EXPECT_THROW((void)see(HumanVision{}, Image<XYZ>(2, 2).view(), -1), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
