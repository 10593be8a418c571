#include "tonemap/global_adaptation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "test_pictures.h"
#include "tonemap/adaptation.h"
#include "tonemap/relative_luminance.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

double adapted(const Adaptation& adaptation, const Image<XYZ>& scene, int threads = 1) {
    return adapt(adaptation, scene.view(), SceneLuminance(scene.view(), threads), threads).uniform_cdm2;
}

/// The same with a NaN, an infinite and a negative pixel in the first row.
Image<XYZ> with_bad_pixels(Image<XYZ> scene) {
    scene(0, 0) = grey(kNan);
    scene(1, 0) = grey(kInf);
    scene(2, 0) = grey(-1e9f);
    return scene;
}

std::vector<Adaptation> global_adaptations() {
    return {LogAverageAdaptation{}, AverageAdaptation{}, MedianAdaptation{}, CentreWeightedAdaptation{},
            SpotAdaptation{0.5f, 0.5f, 0.3f}};
}

TEST(GlobalAdaptation, ConstantPictureHasItsLuminance) {
    Image<XYZ> scene(13, 7);
    for (XYZ& pixel : scene.pixels()) pixel = grey(42.0f);
    for (const Adaptation& adaptation : global_adaptations()) {
        EXPECT_NEAR(adapted(adaptation, scene), 42.0, 42.0 * 1e-12) << to_text(adaptation);
        EXPECT_NEAR(adapted(adaptation, with_bad_pixels(scene)), 42.0, 42.0 * 1e-12) << to_text(adaptation);
    }
}

TEST(GlobalAdaptation, SmallPictureHasTheMeansOfItsName) {
    const Image<XYZ> scene = row_of_greys({1.0f, 4.0f, 16.0f, 0.0f});
    EXPECT_DOUBLE_EQ(adapted(LogAverageAdaptation{}, scene), 4.0);
    EXPECT_DOUBLE_EQ(adapted(AverageAdaptation{}, scene), 5.25);
    EXPECT_NEAR(adapted(MedianAdaptation{}, scene), 4.0, 4.0 / 32.0);
}

TEST(GlobalAdaptation, MedianIsThatOfTheSortedLuminancesToABin) {
    const Image<XYZ> scene = random_scene(101, 103, 1);
    std::vector<float> sorted;
    for (const XYZ& pixel : scene.pixels()) sorted.push_back(pixel.y);
    std::sort(sorted.begin(), sorted.end());
    EXPECT_NEAR(adapted(MedianAdaptation{}, scene) / double{sorted[sorted.size() / 2]}, 1.0, 1.0 / 32.0);
    EXPECT_EQ(adapted(MedianAdaptation{}, row_of_greys({3.3f})), double{3.3f});
}

// Of 3 x 1 pixels, sigma = 1 of the shorter side, 1 pixel: weights e^(-1/2), 1, e^(-1/2).
TEST(GlobalAdaptation, CentreWeightsAreGaussian) {
    const double weight = std::exp(-0.5);
    const double log_average =
        (weight * std::log(2.0) + std::log(100.0) + weight * std::log(8.0)) / (1.0 + 2.0 * weight);
    EXPECT_NEAR(adapted(CentreWeightedAdaptation{1.0f}, row_of_greys({2.0f, 100.0f, 8.0f})), std::exp(log_average),
                1e-12);
    const Image<XYZ> scene = random_scene(31, 17, 2);
    EXPECT_NEAR(adapted(CentreWeightedAdaptation{1e9f}, scene) / adapted(LogAverageAdaptation{}, scene), 1.0, 1e-12);
    // So narrow that all weights are 0 but the centre's, which there is for odd sizes.
    EXPECT_NEAR(adapted(CentreWeightedAdaptation{1e-6f}, scene), double{scene(15, 8).y}, 1e-9);
    // For even sizes there is none: then it is that of the picture.
    EXPECT_NEAR(adapted(CentreWeightedAdaptation{1e-6f}, row_of_greys({1.0f, 16.0f})), 4.0, 1e-12);
}

// A disc of a tenth of 10 pixels about the corner of four pixels: their centres are 0.71 pixels off, the next
// ones 1.58.
TEST(GlobalAdaptation, SpotIsTheLogAverageOfItsDisc) {
    Image<XYZ> scene(20, 10);
    for (XYZ& pixel : scene.pixels()) pixel = grey(1000.0f);
    scene(4, 6) = grey(1.0f);
    scene(5, 6) = grey(2.0f);
    scene(4, 7) = grey(4.0f);
    scene(5, 7) = grey(8.0f);
    EXPECT_NEAR(adapted(SpotAdaptation{0.25f, 0.7f, 0.1f}, scene), std::sqrt(8.0), 1e-12);
    scene(5, 7) = grey(0.0f);
    scene(4, 6) = grey(kNan);
    EXPECT_NEAR(adapted(SpotAdaptation{0.25f, 0.7f, 0.1f}, scene), std::sqrt(8.0), 1e-12);
}

TEST(GlobalAdaptation, SmallestSpotIsAPixelAndTheLargestThePicture) {
    const Image<XYZ> scene = random_scene(20, 10, 3);
    EXPECT_NEAR(adapted(SpotAdaptation{0.26f, 0.74f, 0.0f}, scene) / double{scene(5, 7).y}, 1.0, 1e-12);
    EXPECT_NEAR(adapted(SpotAdaptation{0.0f, 0.0f, 0.0f}, scene) / double{scene(0, 0).y}, 1.0, 1e-12);
    EXPECT_NEAR(adapted(SpotAdaptation{1.0f, 1.0f, 0.0f}, scene) / double{scene(19, 9).y}, 1.0, 1e-12);
    EXPECT_NEAR(adapted(SpotAdaptation{0.5f, 0.5f, 1.0f}, row_of_greys({2.0f, 8.0f})), 4.0, 1e-12);
}

TEST(GlobalAdaptation, BlackSpotTakesThePicture) {
    Image<XYZ> scene(10, 10);
    scene(9, 9) = grey(2.0f);
    scene(9, 8) = grey(8.0f);
    EXPECT_NEAR(adapted(SpotAdaptation{0.1f, 0.1f, 0.1f}, scene), 4.0, 1e-12);
}

// Half of a thousandth of the pixels more, at 1e30: 0.4 % of ln 1e30 would be a third more.
TEST(GlobalAdaptation, OutliersAreLeftOut) {
    const Image<XYZ> scene = random_scene(64, 64, 4);
    Image<XYZ> other = scene;
    other(31, 31) = grey(1e30f);
    other(1, 60) = grey(1e25f);
    ASSERT_GT(1e25, SceneLuminance(other.view(), 1).least_outlier_cdm2());
    for (const Adaptation& adaptation :
         {Adaptation{LogAverageAdaptation{}}, Adaptation{AverageAdaptation{}}, Adaptation{MedianAdaptation{}}}) {
        EXPECT_NEAR(adapted(adaptation, other) / adapted(adaptation, scene), 1.0, 5e-3) << to_text(adaptation);
    }
    // Exactly: the mean of ln of all others, but for the middle of two bins in place of 1e30 and 1e25.
    double log_sum = 0.0;
    for (const XYZ& pixel : other.pixels()) log_sum += pixel.y < 1e20f ? std::log(double{pixel.y}) : 0.0;
    EXPECT_NEAR(std::log(adapted(LogAverageAdaptation{}, other)), log_sum / 4094.0, 2.0 * 0.0156 / 4094.0);
}

TEST(GlobalAdaptation, SameBitsForEveryNumberOfThreads) {
    const Image<XYZ> scene = with_bad_pixels(random_scene(503, 257, 5));
    for (const Adaptation& adaptation : global_adaptations()) {
        const double one = adapted(adaptation, scene, 1);
        for (const int threads : {2, 3, 8, 0})
            EXPECT_EQ(adapted(adaptation, scene, threads), one) << to_text(adaptation);
    }
}

TEST(GlobalAdaptation, ScalesWithTheUnit) {
    const Image<XYZ> scene = random_scene(64, 64, 6);
    for (const float factor : {0x1p-60f, 0x1p60f}) {
        Image<XYZ> other = scene;
        for (XYZ& pixel : other.pixels()) pixel = factor * pixel;
        for (const Adaptation& adaptation : global_adaptations()) {
            EXPECT_NEAR(adapted(adaptation, other) / double{factor} / adapted(adaptation, scene), 1.0, 1e-12);
        }
    }
}

TEST(GlobalAdaptation, TextReadsBackAsTheSameValue) {
    EXPECT_EQ(to_text(Adaptation{SpotAdaptation{0.25f, 0.5f, 0.125f}}), "spot:x=0.25,y=0.5,radius=0.125");
    for (const Adaptation& adaptation : global_adaptations()) {
        EXPECT_EQ(parse_named<Adaptation>(to_text(adaptation), "adaptation"), adaptation);
    }
    EXPECT_THROW((void)parse_named<Adaptation>("spot:x=1.5", "adaptation"), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
