#include "pathtracer/aux_layers.h"

#include <cmath>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "film/film_layers.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"

namespace emulsion::testing {
namespace {

/// A floor of x in [-9, 0] at z = 0, seen from 2 above it, straight down and in a narrow angle; x = 0 is in the middle.
Scene half_floor() {
    return parse_scene(R"(
LookAt 0 0 2  0 0 0  0 1 0
Camera "perspective" "float fov" 0.01
Film "rgb" "integer xresolution" 3 "integer yresolution" 1
WorldBegin
LightSource "infinite" "rgb L" [1 1 1]
Material "diffuse" "rgb reflectance" [0.7 0.4 0.2]
Shape "trianglemesh" "integer indices" [0 1 2 0 2 3] "point3 P" [-9 -9 0  0 -9 0  0 9 0  -9 9 0]
)",
                       "t.pbrt");
}

/// The layers of a row of pixels by their full names.
float value(const FilmPicture& picture, const std::string& name, int x) {
    for (const FloatChannel& channel : picture.floats) {
        if (channel.name == name) return channel.values(x, 0);
    }
    ADD_FAILURE() << name;
    return 0.0f;
}

// The right pixel sees the floor (x runs to the left), the middle one half of it, the left one nothing: values are
// means over what is seen. The floor's colour is that of its RGB, to the 2e-3 by which uplifted reflectances may miss
// it; the angle of 5e-5 lengthens rays by 1e-9 of themselves.
TEST(AuxLayers, ShowTheFirstSurface) {
    for (const FilterUse use : {FilterUse::importance_sampled, FilterUse::splatted}) {
        Scene scene = half_floor();
        FilmOptions options = film_options(scene);
        options.filter = BoxFilter{};
        options.filter_use = use;
        options.aux = known_aux_layers();
        const PreparedScene prepared(std::move(scene), 1);
        Film film(options);
        RenderProgress progress;
        render(prepared, {.samples_per_pixel = 16, .threads = 1}, film, progress);
        const FilmPicture picture = picture_of(film);
        const int floor = 2, nothing = 0;
        for (const int x : {floor, 1}) {
            EXPECT_NEAR(value(picture, "albedo.R", x), 0.7, 2e-3);
            EXPECT_NEAR(value(picture, "albedo.G", x), 0.4, 2e-3);
            EXPECT_NEAR(value(picture, "albedo.B", x), 0.2, 2e-3);
            EXPECT_EQ(value(picture, "normal.X", x), 0.0f);
            EXPECT_EQ(value(picture, "normal.Y", x), 0.0f);
            EXPECT_EQ(value(picture, "normal.Z", x), 1.0f);
            EXPECT_NEAR(value(picture, "depth.Z", x), 2.0, 1e-6);
        }
        for (const char* name : {"albedo.R", "normal.Z", "depth.Z"}) {
            EXPECT_EQ(value(picture, name, nothing), 0.0f) << name;
        }
    }
}

TEST(AuxLayers, ShowTexturesWhereTheyAreSeen) {
    const Scene scene = parse_scene(R"(WorldBegin
Texture "amount" "float" "checkerboard" "float tex1" .25 "float tex2" .75
Texture "board" "spectrum" "checkerboard" "spectrum tex1" [300 .125 900 .125] "spectrum tex2" [300 .5 900 .5]
MakeNamedMaterial "a" "string type" "diffuse" "texture reflectance" "board"
MakeNamedMaterial "b" "string type" "diffuse" "spectrum reflectance" [300 1 900 1]
Material "mix" "string materials" ["a" "b"] "texture amount" "amount"
Shape "sphere")",
                                    "t.pbrt");
    const MaterialAlbedos albedos(scene);
    const auto mix = scene.shapes.at(0).material;
    const auto expect_albedo = [&](int material, Imath::V2f uv, float expected) {
        for (const float component : albedos(material, {{0, 0, 0}, uv})) EXPECT_NEAR(component, expected, 1e-6);
    };
    expect_albedo(mix, {0.5f, 0.5f}, 0.75f * 0.125f + 0.25f);
    expect_albedo(mix, {1.5f, 0.5f}, 0.25f * 0.5f + 0.75f);
}

TEST(AuxLayers, FaceWhoLooksFromBelow) {
    Scene scene;
    scene.materials = {DiffuseMaterial{ConstantSpectrum{0.4}}};
    scene.shapes = {{parallelogram({-1, -1, 3}, {2, 0, 0}, {0, 2, 0}), 0, {}}};
    scene.lights = {UniformInfiniteLight{{ConstantSpectrum{1.0}, 1.0}}};
    std::get<PerspectiveCamera>(scene.camera).fov_deg = 0.01;  // at the origin, along +z
    const PreparedScene prepared(std::move(scene), 1);
    Film film({.width_px = 1, .height_px = 1, .aux = known_aux_layers()});
    RenderProgress progress;
    render(prepared, {.samples_per_pixel = 4, .threads = 1}, film, progress);
    const FilmPicture picture = picture_of(film);
    EXPECT_EQ(value(picture, "normal.Z", 0), -1.0f);
    EXPECT_NEAR(value(picture, "depth.Z", 0), 3.0, 1e-6);
    for (const char* name : {"albedo.R", "albedo.G", "albedo.B"}) EXPECT_NEAR(value(picture, name, 0), 0.4, 1e-6);
}

TEST(AuxLayers, OfOtherNamesAreRefused) {
    EXPECT_THROW(AuxLayers(Scene{}, {{"motion", {"X", "Y"}}}), std::invalid_argument);
    EXPECT_THROW(AuxLayers(Scene{}, {{"depth", {"X", "Y"}}}), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion::testing
