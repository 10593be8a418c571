// The operators whose own adaptation is local, in numbers.

#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "test_pictures.h"
#include "tonemap/tone_mapper.h"
#include "tonemap/visual_capacity.h"

namespace emulsion {
namespace {

constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};

Image<XYZ> map(const ToneMapping& mapping, const Image<XYZ>& scene) {
    return tone_map(mapping, scene.view(), kWhite, 1).image;
}

/// Planes of equal size, side by side.
Image<XYZ> planes(float left_cdm2, float right_cdm2) {
    Image<XYZ> scene(512, 64);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) scene(x, y) = grey(x < 256 ? left_cdm2 : right_cdm2);
    }
    return scene;
}

// In a plane V1 = L, and eq. 9 is eq. 3. The log-average is 1 cd/m^2.
TEST(ReinhardLocal, PlanesHaveTheGlobalCurve) {
    const Image<XYZ> mapped = map({ReinhardLocal{0.18f}}, planes(0.1f, 10.0f));
    EXPECT_NEAR(mapped(20, 32).y, 0.018f / 1.018f, 1e-5f);
    EXPECT_NEAR(mapped(490, 32).y, 1.8f / 2.8f, 1e-4f);
}

// Ld = L / (1 + V1), V1 = key under one adaptation.
TEST(ReinhardLocal, UnderOneAdaptationIsLinear) {
    const Image<XYZ> mapped = map({ReinhardLocal{0.36f}, LogAverageAdaptation{}}, planes(0.1f, 10.0f));
    EXPECT_NEAR(mapped(20, 32).y, 0.036f / 1.36f, 1e-6f);
    EXPECT_NEAR(mapped(490, 32).y, 3.6f / 1.36f, 1e-4f);
}

// A faint texture on a bright plane: dodging and burning keeps its contrast, the global curve flattens it.
TEST(ReinhardLocal, KeepsTextureThatTheGlobalCurveFlattens) {
    Image<XYZ> scene = planes(1.0f, 1000.0f);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 256; x < scene.width(); ++x) {
            if ((x / 4 + y / 4) % 2 == 0) scene(x, y) = grey(1200.0f);
        }
    }
    const auto contrast = [&](const ToneMapper& mapper) {
        const Image<XYZ> mapped = map({mapper}, scene);
        float least = mapped(400, 32).y, most = least;
        for (int x = 400; x < 416; ++x) {
            least = std::min(least, mapped(x, 32).y);
            most = std::max(most, mapped(x, 32).y);
        }
        return most / least;
    };
    EXPECT_LT(contrast(ReinhardGlobal{}), 1.05f);
    EXPECT_GT(contrast(ReinhardLocal{}), 1.1f);
}

// T of the darkest is 0, of the brightest 1, and of a plane between them its share of the differences that can be seen.
TEST(HighContrast, SharesOutTheDifferencesThatCanBeSeen) {
    Image<XYZ> scene(768, 64);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) scene(x, y) = grey(x < 256 ? 0.01f : x < 512 ? 5.0f : 2000.0f);
    }
    const Image<XYZ> mapped = map({HighContrast{}}, scene);
    const double least = visual_capacity(0.01), most = visual_capacity(2000.0);
    // The robust ends are known to a bin of the histogram, 3 % of a luminance: of ln 1.03 / 0.0556 in C.
    const double tolerance = 0.6 / (most - least);
    EXPECT_NEAR(mapped(128, 32).y, 0.0, tolerance);
    EXPECT_NEAR(mapped(384, 32).y, (visual_capacity(5.0) - least) / (most - least), tolerance);
    EXPECT_NEAR(mapped(640, 32).y, 1.0, tolerance);
}

TEST(HighContrast, ConstantPictureIsMiddleGrey) {
    for (const float luminance : {1e-6f, 1.0f, 1e6f}) {
        const Image<XYZ> mapped = map({HighContrast{}}, planes(luminance, luminance));
        for (const XYZ& pixel : mapped.pixels()) EXPECT_NEAR(pixel.y, 0.5f, 1e-4f);
    }
}

// Planes that fill the picture are its base: from 1 : 10000 to 1 : contrast, the brightest at display white.
TEST(Durand, BaseHasTheContrastAskedFor) {
    for (const float contrast : {1.0f, 5.0f, 50.0f}) {
        const Image<XYZ> mapped = map({Durand{contrast}}, planes(0.02f, 200.0f));
        EXPECT_NEAR(mapped(490, 32).y, 1.0f, 0.02f) << contrast;
        EXPECT_NEAR(mapped(490, 32).y / mapped(20, 32).y, contrast, 0.03f * contrast);
    }
}

TEST(Durand, NeverStretches) {
    const Image<XYZ> mapped = map({Durand{1000.0f}}, planes(1.0f, 10.0f));
    EXPECT_NEAR(mapped(490, 32).y / mapped(20, 32).y, 10.0f, 1e-3f);
}

// Texture on either plane comes out with the contrast that it has.
TEST(Durand, KeepsDetail) {
    Image<XYZ> scene = planes(0.02f, 200.0f);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            if ((x + y) % 2 == 0) scene(x, y) = 1.1f * scene(x, y);
        }
    }
    const Image<XYZ> mapped = map({Durand{}}, scene);
    for (const int x : {100, 400}) EXPECT_NEAR(mapped(x, 32).y / mapped(x + 1, 32).y, 1.1f, 0.005f);
}

// Far from the edge it is Ward's scale for that plane; close to it, the halo: what is next to the brighter one is
// darker.
TEST(LocalAdaptation, ScalesPlanesByThemselvesAndHasAHalo) {
    const Image<XYZ> mapped = map({LocalAdaptation{100.0f}, UniformRadiusAdaptation{0.5f}}, planes(1.0f, 1000.0f));
    const auto ward = [](double luminance) {
        const double displayed = just_noticeable_difference_cdm2(50.0);
        return luminance * displayed / just_noticeable_difference_cdm2(luminance) / 100.0;
    };
    EXPECT_NEAR(mapped(20, 32).y / ward(1.0), 1.0, 4e-3);
    EXPECT_NEAR(mapped(490, 32).y / ward(1000.0), 1.0, 4e-3);
    EXPECT_LT(mapped(254, 32).y, 0.1f * mapped(20, 32).y);
    EXPECT_GT(mapped(257, 32).y, 1.2f * mapped(490, 32).y);
}

TEST(LocalAdaptation, VaryingRadiusHasLessOfAHalo) {
    const Image<XYZ> scene = planes(1.0f, 1000.0f);
    const Image<XYZ> uniform = map({LocalAdaptation{}, UniformRadiusAdaptation{0.5f}}, scene);
    const Image<XYZ> varying = map({LocalAdaptation{}, VaryingRadiusAdaptation{}}, scene);
    for (int x = 225; x <= 253; x += 4) EXPECT_GT(varying(x, 32).y, 0.9f * varying(20, 32).y) << x;
    EXPECT_LT(uniform(253, 32).y, 0.1f * uniform(20, 32).y);
}

}  // namespace
}  // namespace emulsion
