// Is the expectation of a render the picture that it should be? 64 independent renders of a small scene, whose means
// differ from the truth by their standard errors and no more: over the blocks of the picture these differences, in
// standard errors, must look like numbers of the normal distribution. A bias shifts them, a wrong error widens them.

#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"
#include "spectrum/colorimetry.h"
#include "support/chi_square.h"
#include "support/kolmogorov_smirnov.h"
#include "support/mean.h"

namespace emulsion::testing {
namespace {

constexpr int kSize_px = 64, kBlock_px = 4;
constexpr int kBlocks = (kSize_px / kBlock_px) * (kSize_px / kBlock_px);
constexpr int kRenders = 64;
constexpr double kFalseAlarm = 1e-3;

/// A scene, and what its blocks are: known, or to be rendered.
struct BiasScene {
    std::string name;
    std::function<Scene()> scene;
    std::function<std::vector<XYZd>()> truth;  ///< of each block; empty: from a long render
};

/// X, Y and Z of each block.
using BlockMeans = std::vector<std::array<Mean, 3>>;

BlockMeans means_of_renders(const PreparedScene& scene, int renders, int samples_per_pixel, std::uint64_t first_seed) {
    BlockMeans means(kBlocks);
    for (int i = 0; i < renders; ++i) {
        Film film(film_options(scene.scene()));
        RenderProgress progress;
        render(scene, {.samples_per_pixel = samples_per_pixel, .seed = first_seed + static_cast<std::uint64_t>(i)},
               film, progress);
        EXPECT_EQ(film.dropped().count(), 0u);
        const Image<XYZ> picture = film.xyz_image();
        std::vector<XYZd> sum(kBlocks);
        for (int y = 0; y < kSize_px; ++y) {
            for (int x = 0; x < kSize_px; ++x) {
                const XYZ& pixel = picture(x, y);
                XYZd& block = sum[static_cast<std::size_t>(y / kBlock_px * (kSize_px / kBlock_px) + x / kBlock_px)];
                block = block +
                        XYZd{static_cast<double>(pixel.x), static_cast<double>(pixel.y), static_cast<double>(pixel.z)};
            }
        }
        for (std::size_t block = 0; block < kBlocks; ++block) {
            const XYZd mean = (1.0 / (kBlock_px * kBlock_px)) * sum[block];
            means[block][0].add(mean.x);
            means[block][1].add(mean.y);
            means[block][2].add(mean.z);
        }
    }
    return means;
}

/// How much work.
struct Effort {
    int samples_per_pixel, reference_renders, reference_samples_per_pixel;
};
#ifdef EMULSION_SLOW_BUILD
constexpr Effort kShort = {1, 16, 8}, kLong = kShort;
#else
constexpr Effort kShort = {4, 64, 16}, kLong = {16, 64, 128};
#endif

struct BiasCase {
    BiasScene scene;
    Sampler sampler;
    Effort effort;
    int cases_in_all;
};
std::ostream& operator<<(std::ostream& out, const BiasCase& bias) { return out << bias.scene.name; }

class Bias : public ::testing::TestWithParam<BiasCase> {};

TEST_P(Bias, ZScoresAreNormal) {
    const auto& [bias_scene, sampler, effort, cases_in_all] = GetParam();
    Scene scene = bias_scene.scene();
    scene.film.width_px = scene.film.height_px = kSize_px;
    scene.filter = BoxFilter{};
    scene.sampler = sampler;
    const PreparedScene prepared(std::move(scene), 0);

    const BlockMeans means = means_of_renders(prepared, kRenders, effort.samples_per_pixel, 1000);
    std::vector<XYZd> truth;
    BlockMeans reference;
    if (bias_scene.truth) {
        truth = bias_scene.truth();
    } else {
        reference = means_of_renders(prepared, effort.reference_renders, effort.reference_samples_per_pixel, 1);
    }

    const double level = sidak_level(kFalseAlarm, 3 * cases_in_all);
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<double> z_scores;
        for (std::size_t block = 0; block < kBlocks; ++block) {
            const Mean& mean = means[block][c];
            double expected = 0.0, error = mean.standard_error();
            if (truth.empty()) {
                expected = reference[block][c].value();
                error = std::hypot(error, reference[block][c].standard_error());
            } else {
                expected = std::array{truth[block].x, truth[block].y, truth[block].z}[c];
            }
            z_scores.push_back((mean.value() - expected) / error);
        }
        const KolmogorovSmirnovResult result = normality_test(z_scores);
        EXPECT_GT(result.p_value, level) << "XYZ"[c] << ": distance from the normal distribution " << result.statistic;
    }
}

// --- Scenes

/// A room in which everything has the radiance L/(1 - a).
BiasScene furnace() {
    const PiecewiseLinearSpectrum emission = slope(0.02, 0.05);
    const auto scene = [emission] {
        Scene room;
        room.materials = {DiffuseMaterial{ConstantSpectrum{0.5}}};
        room.shapes = {{inward_box(), 0, AreaLight{{emission, 1.0}, false, {}}}};
        room.integrator.max_depth = 10000;
        return room;
    };
    return {"Furnace", scene, [emission] { return std::vector<XYZd>(kBlocks, 2.0 * xyz_of_radiance(emission)); }};
}

/// A floor under a panel of [-1, 3] x [-2, 1] at height 2, seen from height 1. Lit by the panel alone, the closed form
/// of the irradiance is known at every point.
BiasScene floor_under_panel() {
    constexpr double kReflectance = 0.7, kHalfWidth = 2.0;  // of the floor in the picture, over its distance
    const PiecewiseLinearSpectrum emission = slope(0.05, 0.02);
    const auto scene = [=] {
        Scene room;
        room.materials = {DiffuseMaterial{ConstantSpectrum{kReflectance}}, DiffuseMaterial{ConstantSpectrum{0.0}}};
        room.shapes = {{parallelogram({-50, -50, 0}, {100, 0, 0}, {0, 100, 0}), 0, {}},
                       {parallelogram({-1, -2, 2}, {0, 3, 0}, {4, 0, 0}), 1, AreaLight{{emission, 1.0}, false, {}}}};
        room.integrator.max_depth = 1;
        PerspectiveCamera camera;
        camera.world_from_camera = Imath::M44d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 1, 1);
        camera.fov_deg = 2.0 * std::atan(kHalfWidth) * 180.0 / std::numbers::pi;
        room.camera = camera;
        return room;
    };
    const auto form_factor = [](double x, double y) {
        const auto corner = [&](double to_x, double to_y) {  // odd in both
            return std::copysign(1.0, to_x) * std::copysign(1.0, to_y) *
                   corner_form_factor(0.5 * std::abs(to_x), 0.5 * std::abs(to_y));
        };
        return corner(3.0 - x, 1.0 - y) - corner(-1.0 - x, 1.0 - y) - corner(3.0 - x, -2.0 - y) +
               corner(-1.0 - x, -2.0 - y);
    };
    const auto truth = [=] {
        // The mean over a block by 32 x 32 midpoints: exact to 1e-5, as the irradiance is smooth.
        constexpr int kSteps = 32, kBlocksAcross = kSize_px / kBlock_px;
        const XYZd once = kReflectance * xyz_of_radiance(emission);
        std::vector<XYZd> blocks;
        for (int by = 0; by < kBlocksAcross; ++by) {
            for (int bx = 0; bx < kBlocksAcross; ++bx) {
                Mean mean;
                for (int i = 0; i < kSteps * kSteps; ++i) {
                    const int column = i % kSteps, row = i / kSteps;
                    const double right = (bx + (column + 0.5) / kSteps) / kBlocksAcross;
                    const double down = (by + (row + 0.5) / kSteps) / kBlocksAcross;
                    mean.add(form_factor(kHalfWidth * (2.0 * right - 1.0), kHalfWidth * (1.0 - 2.0 * down)));
                }
                blocks.push_back(mean.value() * once);
            }
        }
        return blocks;
    };
    return {"FloorUnderPanel", scene, truth};
}

BiasScene from_file(const std::string& name, const std::string& file) {
    return {name, [=] { return read_scene(std::filesystem::path(EMULSION_SOURCE_DIR) / file); }, {}};
}

std::vector<BiasCase> every_case(const Effort& effort) {
    std::vector<BiasCase> cases;
    const int samples = effort.samples_per_pixel;
    for (const BiasScene& scene : {furnace(), floor_under_panel(), from_file("CornellBox", "scenes/cornell-box.pbrt"),
                                   from_file("Metals", "tests/data/reference/metals.pbrt"),
                                   from_file("RgbStillLife", "tests/data/reference/rgb-still-life.pbrt")}) {
        for (const Sampler& sampler : {Sampler{IndependentSampler{samples}}, Sampler{PaddedSobolSampler{samples}}}) {
            cases.push_back({scene, sampler, effort, 0});
        }
    }
    for (BiasCase& bias : cases) bias.cases_in_all = static_cast<int>(cases.size());
    return cases;
}

std::string name_of(const ::testing::TestParamInfo<BiasCase>& info) {
    return info.param.scene.name + (info.param.sampler.index() == 0 ? "Independent" : "PaddedSobol");
}

INSTANTIATE_TEST_SUITE_P(Short, Bias, ::testing::ValuesIn(every_case(kShort)), name_of);
INSTANTIATE_TEST_SUITE_P(Long, Bias, ::testing::ValuesIn(every_case(kLong)), name_of);

}  // namespace
}  // namespace emulsion::testing
