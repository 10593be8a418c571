// Scenes of many triangles are traced through compact hierarchies: the picture must be the same.

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pathtracer/render.h"
#include "scene_text.h"

namespace emulsion::testing {
namespace {

constexpr int kSize_px = 48;
constexpr int kCells = 40;

/// Waves of 2 x kCells^2 triangles on the floor.
std::string waves() {
    std::string positions, indices;
    constexpr int kCorners = kCells + 1;
    for (int j = 0; j < kCorners; ++j) {
        for (int i = 0; i < kCorners; ++i) {
            const double x = 4.0 * i / kCells - 2.0, z = 4.0 * j / kCells;
            positions += fmt::format("{} {} {} ", x, 0.15 * std::sin(7.0 * x) * std::cos(5.0 * z) - 1.0, z);
            const int corner = j * kCorners + i;
            if (i == kCells || j == kCells) continue;
            indices += fmt::format("{} {} {} ", corner, corner + kCorners, corner + 1);
            indices += fmt::format("{} {} {} ", corner + 1, corner + kCorners, corner + kCorners + 1);
        }
    }
    return "Shape \"trianglemesh\" \"integer indices\" [ " + indices + "] \"point3 P\" [ " + positions + "]\n";
}

/// Every kind of geometry that Embree is given, and an object that stands in two places.
std::string scene_text() {
    const std::string mesh = waves();
    return fmt::format("Film \"rgb\" \"integer xresolution\" {0} \"integer yresolution\" {0}\n", kSize_px) +
           R"(Camera "perspective" "float fov" 60
        WorldBegin
        LightSource "infinite" "rgb L" [0.3 0.4 0.5]
        AttributeBegin AreaLightSource "diffuse" Translate 0 2 2 Shape "sphere" "float radius" 0.3 AttributeEnd
        ObjectBegin "bumps" Scale 0.3 0.3 0.3 )" +
           mesh + R"( ObjectEnd
        AttributeBegin Translate -1 0.2 2 ObjectInstance "bumps" AttributeEnd
        AttributeBegin Translate 0.8 0 2.5 Rotate 40 1 1 0 ObjectInstance "bumps" AttributeEnd
        Shape "bilinearmesh" "point3 P" [-2 -1 4  2 -1 4  -2 2 4  2 2 4]
        Shape "bilinearmesh" "point3 P" [-2 -1 1  -2 -1 4  -2 1 2  -1.5 1 4]
        )" +
           mesh;
}

Image<XYZ> picture_of(const PreparedScene& scene) {
    Film film(film_options(scene.scene()));
    RenderProgress progress;
    render(scene, {.samples_per_pixel = 8, .seed = 3, .threads = 1}, film, progress);
    return film.xyz_image();
}

TEST(CompactHierarchy, GivesTheSamePicture) {
    const std::string text = scene_text();
    const PreparedScene fast(parse(text), 1);
    // The mesh itself and the object's.
    const PreparedScene compact(parse(text), 1, SpectralModel{}, std::size_t{2} * 2 * kCells * kCells);
    ASSERT_EQ(fast.accelerator().hierarchy(), Hierarchy::fast);
    ASSERT_EQ(compact.accelerator().hierarchy(), Hierarchy::compact);

    const Image<XYZ> expected = picture_of(fast), picture = picture_of(compact);
    double mean = 0.0;
    for (const XYZ& pixel : expected.pixels()) mean += static_cast<double>(pixel.y) / (kSize_px * kSize_px);
    ASSERT_GT(mean, 0.0);
    int differ = 0;
    for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
        const double difference =
            static_cast<double>(picture.pixels()[i].y) - static_cast<double>(expected.pixels()[i].y);
        if (std::abs(difference) > 1e-4 * mean) ++differ;
    }
    // Where two triangles meet, either may be met.
    EXPECT_LE(differ, kSize_px * kSize_px / 100);
}

/// The limit counts the triangles of all meshes, and is itself many.
TEST(CompactHierarchy, IsForManyTriangles) {
    const std::string text = scene_text();
    const PreparedScene fast(parse(text), 1, SpectralModel{}, std::size_t{2} * 2 * kCells * kCells + 1);
    EXPECT_EQ(fast.accelerator().hierarchy(), Hierarchy::fast);
}

}  // namespace
}  // namespace emulsion::testing
