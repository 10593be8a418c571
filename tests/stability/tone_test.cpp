// Tone mapping: logarithms of the wrong base and of zero, ranges of nothing, neighbourhoods and their edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/image.h"
#include "step_picture.h"
#include "tonemap/gaussian_blur.h"
#include "tonemap/luminance_statistics.h"
#include "tonemap/tone_mapper.h"
#include "tonemap/visual_capacity.h"

namespace emulsion {
namespace {

constexpr XYZ kWhite{0.9505f, 1.0f, 1.089f};
constexpr XYZ grey(float luminance) { return {luminance, luminance, luminance}; }

Image<XYZ> constant(int width, int height, float luminance) {
    Image<XYZ> scene(width, height);
    for (XYZ& pixel : scene.pixels()) pixel = grey(luminance);
    return scene;
}

Image<XYZ> mapped(const ToneMapping& mapping, const Image<XYZ>& scene) {
    return tone_map(mapping, scene.view(), kWhite, 1).image;
}

// --- C(Y)

/// C(Y) below 1 cd/m^2 with the logarithm to base 10 in the place of the natural one, as the code of a classical book
/// has it; above 1 the two agree.
double capacity_by_log10(double y) {
    if (y >= 1.0) return printed_visual_capacity(y);
    return y < 0.0034 ? y / 0.0014 : 2.4483 + std::log10(y / 0.0034) / 0.4027;
}

TEST(VisualCapacity, WithLog10LeapsAtOne) {
    const double below = std::nextafter(1.0, 0.0);
    EXPECT_NEAR(capacity_by_log10(below), 8.578, 0.001);
    EXPECT_NEAR(capacity_by_log10(1.0), 16.563, 0.001);
    EXPECT_NEAR(visual_capacity(1.0) - visual_capacity(below), 0.0, 1e-9);
}

// --- Log-averages

double classic_log_average(const Image<XYZ>& scene) {
    double sum = 0.0;
    for (const XYZ& pixel : scene.pixels()) sum += pixel.y > 0.0f ? std::log(static_cast<double>(pixel.y)) : 0.0;
    return std::exp(sum / static_cast<double>(scene.pixels().size()));
}
double log_average_with_delta(const Image<XYZ>& scene) {
    double sum = 0.0;
    for (const XYZ& pixel : scene.pixels()) sum += std::log(1e-6 + static_cast<double>(pixel.y));
    return std::exp(sum / static_cast<double>(scene.pixels().size()));
}

// Half of a picture of 400 cd/m^2 is black. The classic code leaves zeros out of the sum but not of the count, so that
// they are 1 cd/m^2; a delta makes them 1e-6, whatever the unit.
TEST(LogAverage, OfAPictureWithZeros) {
    Image<XYZ> scene = constant(64, 64, 400.0f);
    for (int y = 0; y < 32; ++y) {
        for (XYZ& pixel : scene.row(y)) pixel = {};
    }
    EXPECT_NEAR(classic_log_average(scene), 20.0, 1e-9);
    EXPECT_NEAR(log_average_with_delta(scene), 0.02, 1e-9);
    EXPECT_NEAR(luminance_statistics(scene.view(), 1).log_average_cdm2, 400.0, 1e-9);
    EXPECT_EQ(luminance_statistics(scene.view(), 1).counts.zero, 64 * 32);

    // In units of 1000 cd/m^2, the same scene: a thousandth of ours, and of the others something else.
    for (XYZ& pixel : scene.pixels()) pixel = 1e-3f * pixel;
    EXPECT_NEAR(1e3 * classic_log_average(scene), 632.5, 0.1);
    EXPECT_NEAR(1e3 * log_average_with_delta(scene), 0.632, 0.001);
    EXPECT_NEAR(1e3 * luminance_statistics(scene.view(), 1).log_average_cdm2, 400.0, 1e-4);
}

TEST(LogAverage, SummedInFloatStopsGrowing) {
    const Image<XYZ> scene = constant(4096, 2048, 20.0f);
    float sum = 0.0f;
    for (const XYZ& pixel : scene.pixels()) sum += std::log(pixel.y);
    EXPECT_NEAR(std::exp(sum / static_cast<float>(scene.pixels().size())), 14.4f, 0.05f);
    EXPECT_NEAR(luminance_statistics(scene.view(), 1).log_average_cdm2, 20.0, 1e-10);
}

// --- T(Y)

TEST(ConstantPicture, IsNothingOverNothingInT) {
    const double c = visual_capacity(20.0);
    EXPECT_TRUE(std::isnan((c - c) / (c - c)));
    const Image<XYZ> picture = mapped({HighContrast{}}, constant(16, 16, 20.0f));
    for (const XYZ& pixel : picture.pixels()) EXPECT_NEAR(pixel.y, 0.5f, 1e-3f);
}

// --- Halos

/// How far a pixel near the edge, of an even plane, is from one far from it: the largest ratio, either way, within 24
/// pixels of the edge on its dark side; the two next to it are left out.
double halo(const Image<XYZ>& picture) {
    double largest = 1.0;
    for (int x = 232; x < 254; ++x) {
        const double ratio = static_cast<double>(picture(x, 32).y) / static_cast<double>(picture(20, 32).y);
        largest = std::max({largest, ratio, 1.0 / ratio});
    }
    return largest;
}

TEST(Halos, OfGaussianSurroundsAreGoneFromThoseThatStopAtEdges) {
    const Image<XYZ> scene = stability::step();
    EXPECT_NEAR(halo(stability::over_gaussian_surround(scene)), 219.5, 0.5);
    EXPECT_NEAR(halo(mapped({Durand{}}, scene)), 1.0, 0.05);
    EXPECT_NEAR(halo(mapped({ReinhardLocal{}}, scene)), 1.0, 0.05);
    EXPECT_NEAR(halo(mapped({LocalAdaptation{}, VaryingRadiusAdaptation{}}, scene)), 1.0, 0.05);
    // The operator that is known for it shows it, as published.
    EXPECT_GT(halo(mapped({LocalAdaptation{}}, scene)), 2.0);
}

// --- Pyramids

/// A level of a pyramid as many write it: [1 4 6 4 1] / 16 about every second pixel, 0 past the edges, floor(n / 2)
/// wide.
std::vector<float> down(const std::vector<float>& row) {
    constexpr std::array kKernel = {1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};
    std::vector<float> half(row.size() / 2);
    for (std::size_t i = 0; i < half.size(); ++i) {
        for (std::size_t k = 0; k < kKernel.size(); ++k) {
            const std::size_t at = 2 * i + k;
            if (at >= 2 && at - 2 < row.size()) half[i] += kKernel[k] * row[at - 2];
        }
    }
    return half;
}

/// Of a row that stands for pixels `spacing` wide, the first from 0 on: sum and centre of its light.
struct Light {
    double sum = 0.0, centre = 0.0;
};
Light light_of(std::span<const float> row, double spacing) {
    Light light;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double share = spacing * static_cast<double>(row[i]);
        light.sum += share;
        light.centre += share * (spacing * (static_cast<double>(i) + 0.5) - 0.5);
    }
    light.centre /= light.sum;
    return light;
}

// 101 pixels become 50, 25, 12, 6 and 3. The last of an odd number belongs to nobody, the outermost of each level take
// zeros for neighbours, and level by level pixels are further to the left than those that they are put back to.
TEST(Pyramid, OfOddSizesLosesLightAndPlace) {
    std::vector<float> flat(101, 1.0f);
    for (int level = 0; level < 5; ++level) flat = down(flat);
    ASSERT_EQ(flat.size(), 3u);
    EXPECT_NEAR(flat[0], 0.491f, 0.001f);

    std::vector<float> point(101);
    point[50] = 1000.0f;
    for (int level = 0; level < 3; ++level) point = down(point);
    EXPECT_NEAR(light_of(point, 8.0).centre - 50.0, 3.5, 0.01);

    // Ours, through as many levels: a constant is constant, and a point's light stays what and where it was.
    Image<float> ours(101, 67);
    std::ranges::fill(ours.pixels(), 1.0f);
    ours = gaussian_blur(std::move(ours), 30.0, 1);
    for (const float p : ours.pixels()) EXPECT_NEAR(p, 1.0f, 1e-5f);
    std::ranges::fill(ours.pixels(), 0.0f);
    for (int y = 0; y < 67; ++y) ours(50, y) = 1000.0f;
    ours = gaussian_blur(std::move(ours), 12.0, 1);
    const Light light = light_of(ours.row(33), 1.0);
    EXPECT_NEAR(light.sum, 1000.0, 0.01);
    EXPECT_NEAR(light.centre - 50.0, 0.0, 1e-3);
}

// --- One bad pixel

// A blur of 8 pixels takes a NaN to the 4900 pixels within 35 of it.
TEST(BadPixel, SpreadsThroughBlurs) {
    Image<XYZ> scene = constant(128, 128, 20.0f);
    scene(64, 64) = grey(std::numeric_limits<float>::quiet_NaN());
    Image<float> luminance(128, 128);
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) luminance.pixels()[i] = scene.pixels()[i].y;
    const Image<float> blurred = gaussian_blur(luminance, 8.0, 1);
    const auto is_nan = [](float p) { return std::isnan(p); };
    EXPECT_EQ(std::count_if(blurred.pixels().begin(), blurred.pixels().end(), is_nan), 4900);

    const Image<XYZ> picture = mapped({ReinhardLocal{}}, scene),
                     expected = mapped({ReinhardLocal{}}, constant(128, 128, 20.0f));
    EXPECT_EQ(picture(64, 64), XYZ{});
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 128; ++x) {
            if (x == 64 && y == 64) continue;
            EXPECT_NEAR(picture(x, y).y, expected(x, y).y, 1e-5f) << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace emulsion
