#include "pathtracer/render.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analytic_scenes.h"

namespace emulsion::testing {
namespace {

/// Hills of 2 x 200 x 200 triangles under a sky and a lamp: enough for Embree to build its hierarchy in parallel.
Scene hills() {
    constexpr std::uint32_t kSide = 200;
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= kSide; ++i) {
        for (std::uint32_t j = 0; j <= kSide; ++j) {
            const float x = static_cast<float>(j) / kSide - 0.5f, y = static_cast<float>(i) / kSide - 0.5f;
            mesh.position.emplace_back(x, y, 0.02f * std::sin(40.0f * x) * std::sin(30.0f * y));
            if (i == kSide || j == kSide) continue;
            const std::uint32_t corner = i * (kSide + 1) + j;
            mesh.triangle.push_back({corner, corner + 1, corner + kSide + 2});
            mesh.triangle.push_back({corner, corner + kSide + 2, corner + kSide + 1});
        }
    }
    Scene scene;
    scene.materials = {DiffuseMaterial{slope(0.3, 0.8)}};
    scene.shapes = {{mesh, 0, {}}};
    scene.lights = {UniformInfiniteLight{{ConstantSpectrum{1e-3}, 1.0}},
                    PointLight{{0.1, 0.1, 0.3}, {ConstantSpectrum{1e-3}, 1.0}}};
    // Looks down from z = 1.
    PerspectiveCamera& camera = std::get<PerspectiveCamera>(scene.camera);
    camera.world_from_camera = Imath::M44d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 1, 1);
    camera.fov_deg = 50.0;
    return scene;
}

Image<XYZ> rendered(const RenderOptions& options, int build_threads) {
    const PreparedScene prepared(hills(), build_threads);
    Film film({.width_px = 50, .height_px = 40});
    RenderProgress progress;
    render(prepared, options, film, progress);
    return film.xyz_image();
}

TEST(Render, AMeshBuiltAndRenderedByAnyNumberOfThreadsGivesTheSameBits) {
    const Image<XYZ> one = rendered({.samples_per_pixel = 20, .threads = 1}, 1);
    for (const int threads : {2, 3, 8}) {
        EXPECT_TRUE(rendered({.samples_per_pixel = 20, .threads = threads}, threads) == one) << threads;
    }
    EXPECT_FALSE(rendered({.samples_per_pixel = 20, .seed = 1, .threads = 1}, 1) == one);
}

TEST(Render, StoppedBeforeItStartsItAddsNothing) {
    const PreparedScene prepared(hills(), 1);
    Film film({.width_px = 50, .height_px = 40});
    RenderProgress progress;
    progress.stop = true;
    render(prepared, {}, film, progress);
    EXPECT_EQ(film.sample_count(), 0u);
    EXPECT_EQ(progress.samples_done, 0);
}

TEST(Render, AddsExactlyTheSamplesAskedFor) {
    for (const int samples : {1, 2, 3, 15, 16, 17, 33}) {
        const PreparedScene prepared(hills(), 1);
        Film film({.width_px = 20, .height_px = 17});
        RenderProgress progress;
        render(prepared, {.samples_per_pixel = samples, .threads = 2}, film, progress);
        EXPECT_EQ(film.min_samples_per_pixel(), static_cast<std::uint64_t>(samples));
        EXPECT_EQ(film.max_samples_per_pixel(), static_cast<std::uint64_t>(samples));
        EXPECT_EQ(progress.samples_done, 20 * 17 * samples);
    }
}

TEST(Render, RefusesOptionsOutOfRange) {
    for (const RenderOptions& options :
         {RenderOptions{.samples_per_pixel = 0}, RenderOptions{.samples_per_pixel = (1 << 24) + 1},
          RenderOptions{.wavelengths = 3}, RenderOptions{.threads = -1}}) {
        EXPECT_THROW(validate(options), std::invalid_argument);
    }
}

/// Coordinates far from 1 must not change the picture: a white floor under a sky of radiance 1 has radiance 1.
TEST(Render, FloorsOfAnySizeReflectAlike) {
    for (const float size : {1e-12f, 1e-4f, 1.0f, 1e6f, 1e10f, 1e14f}) {
        Scene scene;
        scene.materials = {DiffuseMaterial{ConstantSpectrum{1.0}}};
        scene.shapes = {{parallelogram({-size, -size, 0}, {2 * size, 0, 0}, {0, 2 * size, 0}), 0, {}}};
        scene.lights = {UniformInfiniteLight{{ConstantSpectrum{1.0}, 1.0}}};
        scene.integrator.max_depth = 1;
        const auto estimate = estimate_radiance(scene, {{0.1f * size, 0, size}, {0, 0, -1}}, 20000);
        EXPECT_NEAR(estimate.mean[0], 1.0, 4.0 * estimate.standard_error[0]) << size;
        EXPECT_LT(estimate.standard_error[0], 0.01) << size;
    }
}

TEST(Render, CoordinatesBeyondEmbreeAreAnError) {
    Scene scene;
    scene.materials = {DiffuseMaterial{}};
    scene.shapes = {{parallelogram({-1e19f, 0, 0}, {2e19f, 0, 0}, {0, 2e19f, 0}), 0, {}}};
    EXPECT_THROW(PreparedScene(scene, 1), std::runtime_error);
}

}  // namespace
}  // namespace emulsion::testing
