#include "pathtracer/render.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "pathtracer/scene_transform.h"

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

Image<XYZ> pictured(const Scene& scene, const RenderOptions& options) {
    const PreparedScene prepared(scene, 1);
    Film film(film_options(scene));
    RenderProgress progress;
    render(prepared, options, film, progress);
    return film.xyz_image();
}

/// A lamp that all rays of a camera meet or miss by their directions alone: no other numbers are drawn.
Scene lamp_alone() {
    Scene scene;
    scene.materials = {DiffuseMaterial{}};
    scene.shapes = {{Sphere{translation({0, 0, 3}), 1.0}, 0, AreaLight{{slope(0.3, 0.8), 1.0}}}};
    scene.film.width_px = scene.film.height_px = 16;
    scene.integrator.max_depth = 0;
    return scene;
}

TEST(Render, WithoutJitterAllPathsOfAPixelAreOne) {
    Scene scene = lamp_alone();
    std::get<PerspectiveCamera>(scene.camera).lens = {0.2, 2.0};
    scene.jitter = {.pixel = false, .wavelength = false};
    const auto image = [&](std::uint64_t seed, int samples) {
        return pictured(scene, {.samples_per_pixel = samples, .seed = seed, .threads = 1});
    };
    EXPECT_TRUE(image(1, 1) == image(2, 1));
    EXPECT_TRUE(image(1, 1) == image(1, 4));
    scene.jitter = {.pixel = true, .wavelength = false};
    EXPECT_FALSE(image(1, 1) == image(2, 1));
    scene.jitter = {.pixel = false, .wavelength = true};
    EXPECT_FALSE(image(1, 1) == image(2, 1));
}

/// The lens draws numbers only where there is one: pictures of pinholes stay what they are.
TEST(Render, LensesBlurWhatIsOutOfFocus) {
    const auto edge_pixels = [](double radius, double focal_distance) {
        Scene scene = lamp_alone();
        scene.film.width_px = scene.film.height_px = 32;  // 16 pixels for a slope of 1
        scene.filter = BoxFilter{};
        std::get<PerspectiveCamera>(scene.camera).lens = {radius, focal_distance};
        const Image<XYZ> image = pictured(scene, {.samples_per_pixel = 16, .threads = 1});
        const float full = image(16, 16).y;
        int partly = 0;
        for (int x = 0; x < 32; ++x) partly += image(x, 16).y > 0.02f * full && image(x, 16).y < 0.7f * full ? 1 : 0;
        return partly;
    };
    // The rim that the pinhole sees is at z = 8/3. Focused at 1000, its circle of confusion is 1 across, which is 1 / z
    // = 3/8 in slope, or 6 pixels, on either side.
    EXPECT_LE(edge_pixels(0.0, 1000.0), 2);
    EXPECT_LE(edge_pixels(0.5, 8.0 / 3.0), 4);
    EXPECT_GE(edge_pixels(0.5, 1000.0), 6);
}

TEST(Render, RefusesOptionsOutOfRange) {
    for (const RenderOptions& options :
         {RenderOptions{.samples_per_pixel = 0}, RenderOptions{.samples_per_pixel = (1 << 24) + 1},
          RenderOptions{.model = SpectralModel{3}}, RenderOptions{.threads = -1}}) {
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
