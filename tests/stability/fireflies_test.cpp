// Estimates of infinite variance, as path tracers have of caustics through small lights: what robust estimators buy,
// and what they cost.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "caustic.h"
#include "film/film.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/prepared_scene.h"

namespace emulsion {
namespace {

using stability::caustic_film;
using stability::kCausticMean;

struct Pixels {
    Image<XYZ> picture;
    FilmCounts counts;
    [[nodiscard]] double mean() const {
        double sum = 0.0;
        for (const XYZ& pixel : picture.pixels()) sum += static_cast<double>(pixel.y);
        return sum / static_cast<double>(picture.pixels().size());
    }
    /// The mean distance from the true mean, over it.
    [[nodiscard]] double error() const {
        double sum = 0.0;
        for (const XYZ& pixel : picture.pixels()) sum += std::abs(static_cast<double>(pixel.y) - kCausticMean);
        return sum / static_cast<double>(picture.pixels().size()) / kCausticMean;
    }
    [[nodiscard]] double brightest() const {
        float largest = 0.0f;
        for (const XYZ& pixel : picture.pixels()) largest = std::max(largest, pixel.y);
        return static_cast<double>(largest);
    }
};

Pixels render(const FireflyControl& control, std::uint64_t samples) {
    const auto film = caustic_film(control, samples);
    return {film->xyz_image(), film->counts()};
}

TEST(InfiniteVariance, RobustEstimatorsTradeFirefliesForBias) {
    const Pixels plain = render(NoFireflyControl{}, 256), median = render(MedianOfMeans{5}, 256),
                 clamped = render(LuminanceClamp{100.0f}, 256);
    EXPECT_GT(plain.brightest(), 13.0 * kCausticMean);
    EXPECT_NEAR(plain.mean() / kCausticMean, 0.953, 0.005);
    EXPECT_NEAR(plain.error(), 0.245, 0.005);

    // The median takes the fireflies and a fifth of the light; the mean distance from the truth hardly changes.
    EXPECT_LT(median.brightest(), 3.0 * kCausticMean);
    EXPECT_NEAR(median.mean() / kCausticMean, 0.797, 0.005);
    EXPECT_NEAR(median.error(), 0.225, 0.005);

    EXPECT_LT(clamped.brightest(), 3.0 * kCausticMean);
    EXPECT_NEAR(clamped.mean() / kCausticMean, 0.838, 0.005);
    EXPECT_NEAR(clamped.error(), 0.173, 0.005);

    // E[min(X, c)] = mean - a / (1 - a) c^(1 - 1 / a): what the clamp takes is known, and kept count of.
    const double taken = 3.0 * std::pow(100.0, -1.0 / 3.0);
    EXPECT_NEAR(kCausticMean - clamped.mean(), taken, 0.02);
    const double removed = clamped.counts.clamped.removed_luminance.value() / (256.0 * 32.0 * 32.0);
    EXPECT_NEAR(clamped.mean() + removed, plain.mean(), 1e-4);
}

/// A floor in the shadow of a glass ball, a small lamp above. All of its light comes through the ball, and no shadow
/// ray does: a path finds the lamp by chance.
Scene ball_and_lamp() {
    TriangleMesh floor;
    floor.position = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
    floor.triangle = {{0, 1, 2}, {0, 2, 3}};
    Imath::M44d ball, lamp;
    ball.setTranslation(Imath::V3d(0, 0, 2));
    lamp.setTranslation(Imath::V3d(0, 0, 8));
    Scene scene;
    scene.materials = {DiffuseMaterial{ConstantSpectrum{0.5}}, DielectricMaterial{ConstantSpectrum{1.5}, {}}};
    scene.shapes = {{floor, 0, {}},
                    {Sphere{ball, 1.0}, 1, {}},
                    {Sphere{lamp, 0.005}, 0, AreaLight{{ConstantSpectrum{1.0}, 1000.0}, false}}};
    scene.integrator.max_depth = 6;
    return scene;
}

// 1024 pixels of 256 paths that see the same place. Few paths carry all of the light, and most groups of 51 none: of
// their median an eighth of the caustic is left. This is bias at its worst, and why nothing of the kind is on by
// default.
TEST(Caustic, OfASmallLampIsLostToTheMedian) {
    const PreparedScene scene(ball_and_lamp(), 1);
    PathIntegrator<SpectralTransport<1>> integrator(scene, 6);
    Film plain({32, 32, {}}), median({.width_px = 32, .height_px = 32, .firefly_control = MedianOfMeans{5}});
    FilmTile plain_tile = plain.make_tile(plain.bounds()), median_tile = median.make_tile(median.bounds());
    std::vector<Path<SpectralTransport<1>>> paths(32 * 32);
    double brightest_path = 0.0;
    for (int i = 0; i < 256; ++i) {
        median_tile.set_sample_index(static_cast<std::uint64_t>(i));
        for (int p = 0; p < 32 * 32; ++p) {
            auto& path = paths[static_cast<std::size_t>(p)] = {};
            path.ray = Ray{{6, 0, 1}, Imath::V3f(-6, 0, -1).normalized()};
            path.samples = SampleSequence(IndependentSampler{}, 2, p % 32, p / 32, i);
            path.wavelengths.lambda_nm[0] = 550.0f;
            path.wavelengths.pdf[0] = 1.0f;
            path.index = SpectrumTableIndex<1>(path.wavelengths.lambda_nm);
        }
        integrator.trace(paths);
        for (int p = 0; p < 32 * 32; ++p) {
            const float value = paths[static_cast<std::size_t>(p)].radiance.value[0];
            brightest_path = std::max(brightest_path, static_cast<double>(value));
            plain_tile.add(p % 32, p / 32, XYZ{value, value, value}, 1.0f);
            median_tile.add(p % 32, p / 32, XYZ{value, value, value}, 1.0f);
        }
    }
    plain.merge(plain_tile), median.merge(median_tile);
    const Pixels of_mean{plain.xyz_image(), plain.counts()}, of_median{median.xyz_image(), median.counts()};
    EXPECT_NEAR(brightest_path / of_mean.mean(), 368.0, 2.0);
    EXPECT_NEAR(of_mean.brightest() / of_mean.mean(), 7.18, 0.05);
    EXPECT_NEAR(of_median.mean() / of_mean.mean(), 0.126, 0.005);
}

/// The exponent at which the error falls with the number of samples.
double slope(const FireflyControl& control, std::uint64_t few, std::uint64_t many) {
    return std::log(render(control, many).error() / render(control, few).error()) /
           std::log(static_cast<double>(many) / static_cast<double>(few));
}

/// Without a variance, sums of n converge as n^(a - 1) = n^-1/4 and not as n^-1/2: four times the samples for 0.7 of
/// the error.
void expect_slow_convergence(std::uint64_t few, std::uint64_t many) {
    EXPECT_NEAR(slope(NoFireflyControl{}, few, many), -0.25, 0.08);
    EXPECT_NEAR(slope(MedianOfMeans{5}, few, many), -0.25, 0.08);
}

struct Effort {
    std::uint64_t few, many;
};
class InfiniteVarianceSlope : public testing::TestWithParam<Effort> {};
TEST_P(InfiniteVarianceSlope, IsThatOfTheFourthRoot) { expect_slow_convergence(GetParam().few, GetParam().many); }
std::string effort_name(const testing::TestParamInfo<Effort>& info) { return "To" + std::to_string(info.param.many); }
INSTANTIATE_TEST_SUITE_P(Short, InfiniteVarianceSlope, testing::Values(Effort{16, 1024}), effort_name);
INSTANTIATE_TEST_SUITE_P(Long, InfiniteVarianceSlope, testing::Values(Effort{64, 65536}), effort_name);

}  // namespace
}  // namespace emulsion
