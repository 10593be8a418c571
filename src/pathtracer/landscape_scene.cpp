#include "pathtracer/landscape_scene.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace emulsion {

namespace {

/// Hills on hills, each half as wide as the one before; unevenly turned, so that nothing repeats. Of x and z in [0, 1].
float height_of(float x, float z) noexcept {
    float height = 0.0f, size = 0.12f;
    for (int octave = 0; octave < 5; ++octave) {
        const float frequency = 9.0f * static_cast<float>(1 << octave), turn = 0.7f + static_cast<float>(octave);
        const float along = std::cos(turn) * x + std::sin(turn) * z, across = std::cos(turn) * z - std::sin(turn) * x;
        height += size * std::sin(frequency * along) * std::cos(frequency * across);
        size *= 0.45f;
    }
    return height;
}

/// A grid of side 10 below the origin.
TriangleMesh landscape(std::int64_t triangles) {
    const auto cells = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(triangles) / 2.0)));
    const std::uint32_t corners = cells + 1;
    TriangleMesh mesh;
    mesh.position.reserve(std::size_t{corners} * corners + kRoomBehind);
    mesh.triangle.reserve(std::size_t{2} * cells * cells);
    for (std::uint32_t j = 0; j < corners; ++j) {
        for (std::uint32_t i = 0; i < corners; ++i) {
            const float x = static_cast<float>(i) / static_cast<float>(cells);
            const float z = static_cast<float>(j) / static_cast<float>(cells);
            mesh.position.emplace_back(10.0f * x - 5.0f, 10.0f * height_of(x, z) - 4.0f, 10.0f * z + 1.0f);
        }
    }
    for (std::uint32_t j = 0; j < cells; ++j) {
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t corner = j * corners + i;
            mesh.triangle.push_back({corner, corner + corners, corner + 1});
            mesh.triangle.push_back({corner + 1, corner + corners, corner + corners + 1});
        }
    }
    return mesh;
}

}  // namespace

Scene landscape_scene(std::int64_t triangles, int side_px) {
    if (triangles < 1 || triangles > 1'000'000'000) {
        throw std::invalid_argument(fmt::format("triangles: {}, expected 1 to 1e9", triangles));
    }
    Imath::M44d world_from_camera;
    world_from_camera.rotate(Imath::V3d(0.6, 0.0, 0.0));
    TriangleMesh lamp;
    lamp.position.reserve(4 + kRoomBehind);
    lamp.position = {{-1, 2, 5}, {1, 2, 5}, {1, 2, 7}, {-1, 2, 7}};
    lamp.triangle = {{0, 1, 2}, {0, 2, 3}};

    Scene scene;
    PerspectiveCamera camera;
    camera.world_from_camera = world_from_camera;
    camera.fov_deg = 50.0;
    scene.camera = camera;
    scene.sampler = IndependentSampler{};
    scene.filter = BoxFilter{};
    scene.film.width_px = scene.film.height_px = side_px;
    scene.materials = {DiffuseMaterial{}};
    const ScaledSpectrum white{ConstantSpectrum{1.0}, 1.0};
    scene.shapes.push_back({landscape(triangles), 0, {}});
    scene.shapes.push_back({std::move(lamp), 0, AreaLight{.radiance = {white.spectrum, 20.0}}});
    scene.lights = {UniformInfiniteLight{white}};
    return scene;
}

}  // namespace emulsion
