#include "pathtracer/scene_transform.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "scene_text.h"

namespace emulsion {
namespace {

using testing::parse;
using testing::parse_world;

constexpr double kTolerance = 1e-12;

void expect_near(const Imath::V3d& a, const Imath::V3d& b, const std::string& what = "") {
    EXPECT_NEAR(a.x, b.x, kTolerance) << what;
    EXPECT_NEAR(a.y, b.y, kTolerance) << what;
    EXPECT_NEAR(a.z, b.z, kTolerance) << what;
}

/// Where the directives bring the point (1, 2, 3): the position of a point light there.
Imath::V3d moved(const std::string& directives) {
    const Scene scene = parse_world(directives + R"( LightSource "point" "point3 from" [1 2 3])");
    return std::get<PointLight>(scene.lights.at(0)).position;
}

TEST(SceneTransform, EveryDirectiveMovesPoints) {
    expect_near(moved(""), {1, 2, 3});
    expect_near(moved("Translate 10 20 30"), {11, 22, 33});
    expect_near(moved("Scale 2 3 -4"), {2, 6, -12});
    expect_near(moved("Rotate 90 0 0 1"), {-2, 1, 3});
    expect_near(moved("Rotate 90 5 0 0"), {1, -3, 2});
    expect_near(moved("Rotate 90 0 .1 0"), {3, 2, -1});
    expect_near(moved("Rotate -270 0 0 1"), {-2, 1, 3});
    expect_near(moved("Transform [1 0 0 0  0 1 0 0  0 0 1 0  10 20 30 1]"), {11, 22, 33});
    // The first four numbers are where x goes.
    expect_near(moved("Transform [0 1 0 0  -1 0 0 0  0 0 1 0  10 20 30 1]"), {8, 21, 33});
    expect_near(moved("ConcatTransform [0 1 0 0  -1 0 0 0  0 0 1 0  10 20 30 1]"), {8, 21, 33});
    expect_near(moved("Transform 1 0 0 0  0 1 0 0  0 0 1 0  10 20 30 1"), {11, 22, 33});
    expect_near(moved("Translate [10 20 30]"), {11, 22, 33});
    expect_near(moved("Translate 10 20 30 Identity"), {1, 2, 3});
}

TEST(SceneTransform, LaterDirectivesActOnPointsFirst) {
    expect_near(moved("Translate 10 20 30 Scale 2 2 2"), {12, 24, 36});
    expect_near(moved("Scale 2 2 2 Translate 10 20 30"), {22, 44, 66});
    expect_near(moved("Scale 2 2 2 ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 10 20 30 1]"), {22, 44, 66});
    expect_near(moved("Scale 2 2 2 Transform [1 0 0 0 0 1 0 0 0 0 1 0 10 20 30 1]"), {11, 22, 33});
}

TEST(SceneTransform, RotationKeepsItsAxisAndLengths) {
    const Imath::V3d axis(1, -2, 0.5);
    const Imath::M44d turn = rotation(37.0, axis);
    expect_near(transform_point(turn, axis), axis);
    const Imath::V3d p(3, 1, -4);
    EXPECT_NEAR(transform_point(turn, p).length(), p.length(), kTolerance);
    expect_near(transform_point(turn * rotation(-37.0, axis), p), p);
}

TEST(SceneTransform, AttributeBlocksSaveIt) {
    expect_near(moved("Translate 1 1 1 AttributeBegin Scale 5 5 5 AttributeEnd"), {2, 3, 4});
    expect_near(moved("AttributeBegin AttributeBegin Scale 5 5 5 AttributeEnd Translate 1 0 0 AttributeEnd"),
                {1, 2, 3});
}

TEST(SceneTransform, WorldBeginSetsItBack) {
    const Scene scene = parse("Translate 5 5 5 WorldBegin LightSource \"point\"");
    expect_near(std::get<PointLight>(scene.lights[0]).position, {0, 0, 0});
}

Imath::V3d in_world(const Scene& scene, const Imath::V3d& camera_point) {
    return transform_point(std::get<PerspectiveCamera>(scene.camera).world_from_camera, camera_point) + scene.origin;
}

/// The scene's own origin is at the camera, so that nothing is rounded far from it.
TEST(SceneTransform, WorldSpaceHasItsOriginAtTheCamera) {
    const std::string look = "LookAt 1e9 20 30  1e9 20 31  0 1 0 Camera \"perspective\" WorldBegin ";
    for (const char* const place :
         {"Translate 1e9 20 30 Translate 0.125 1 2", "Identity Translate 1e9 21 32 Translate .125 0 0",
          "Transform [1 0 0 0 0 1 0 0 0 0 1 0 1000000000.125 21 32 1]"}) {
        const Scene scene = parse(look + place + " LightSource \"point\" Shape \"sphere\"");
        expect_near(scene.origin, {1e9, 20, 30});
        EXPECT_EQ(std::get<PerspectiveCamera>(scene.camera).world_from_camera.translation(), Imath::V3d(0.0)) << place;
        EXPECT_EQ(std::get<PointLight>(scene.lights.at(0)).position, Imath::V3d(0.125, 1, 2)) << place;
        EXPECT_EQ(std::get<Sphere>(scene.shapes.at(0).geometry).world_from_object.translation(),
                  Imath::V3d(0.125, 1, 2))
            << place;
    }
}

TEST(SceneTransform, LookAtMakesALeftHandedFrame) {
    // From (0, 0, -5) along +z with y up, +x is to the right.
    const Scene scene = parse("LookAt 0 0 -5  0 0 0  0 1 0 Camera \"perspective\" WorldBegin");
    expect_near(in_world(scene, {0, 0, 0}), {0, 0, -5});
    expect_near(in_world(scene, {0, 0, 1}), {0, 0, -4});
    expect_near(in_world(scene, {1, 0, 0}), {1, 0, -5});
    expect_near(in_world(scene, {0, 1, 0}), {0, 1, -5});
    EXPECT_FALSE(swaps_handedness(std::get<PerspectiveCamera>(scene.camera).world_from_camera));
}

TEST(SceneTransform, LookAtFromTheSide) {
    // From (4, 1, 0) along -x with z up, right is up x forward = z x -x = -y.
    const Scene scene = parse("LookAt 4 1 0  0 1 0  0.3 0 2 Camera \"perspective\" WorldBegin");
    expect_near(in_world(scene, {0, 0, 2}), {2, 1, 0});
    expect_near(in_world(scene, {1, 0, 0}), {4, 0, 0});
    expect_near(in_world(scene, {0, 1, 0}), {4, 1, 1});
}

TEST(SceneTransform, TheCameraInvertsWhatStandsBeforeIt) {
    const Scene scene = parse(
        "Scale -1 1 1 LookAt 278 273 -800  278 273 -799  0 1 0 Camera \"perspective\" Translate 9 9 9 WorldBegin");
    expect_near(in_world(scene, {0, 0, 0}), {278, 273, -800});
    expect_near(in_world(scene, {1, 0, 0}), {277, 273, -800});
    EXPECT_TRUE(swaps_handedness(std::get<PerspectiveCamera>(scene.camera).world_from_camera));
}

TEST(SceneTransform, NormalsStayPerpendicular) {
    const Imath::M44d matrix = rotation(30, {1, 1, 0}) * scaling({1, 5, 0.25}) * translation({7, 8, 9});
    const Imath::V3d u(1, 2, 3), v(-2, 0, 1), n = u.cross(v);
    const Imath::V3d moved_n = transform_vector(normal_matrix(matrix).value(), n);
    EXPECT_NEAR(moved_n.dot(transform_vector(matrix, u)), 0.0, kTolerance * 100);
    EXPECT_NEAR(moved_n.dot(transform_vector(matrix, v)), 0.0, kTolerance * 100);
}

TEST(SceneTransform, InvertibleAtEveryScale) {
    for (const double scale : {1e-12, 1e-4, 1.0, 1e4, 1e12}) {
        EXPECT_TRUE(is_invertible(rotation(20, {1, 2, 3}) * scaling(Imath::V3d(scale)))) << scale;
        EXPECT_FALSE(is_invertible(rotation(20, {1, 2, 3}) * scaling({scale, scale, 0.0}))) << scale;
    }
    EXPECT_TRUE(is_invertible(scaling({1e6, 1, 1e-6})));
    EXPECT_FALSE(is_invertible(scaling({HUGE_VAL, 1, 1})));
}

TEST(SceneTransform, RefusesWhatIsNoFrame) {
    using testing::error_of;
    const std::string singular =
        "found a singular transformation, expected one that maps space to space, neither flattened nor overflowing";
    EXPECT_EQ(error_of("Scale 1 0 1"), "t.pbrt:1:1: " + singular);
    EXPECT_EQ(error_of("Identity\n Transform [1 0 0 0  2 0 0 0  0 0 1 0  0 0 0 1]"), "t.pbrt:2:2: " + singular);
    EXPECT_EQ(error_of("Scale 1e200 1e200 1e200 Scale 1e200 1 1"), "t.pbrt:1:25: " + singular);
    EXPECT_EQ(
        error_of("ConcatTransform [1 0 0 1  0 1 0 0  0 0 1 0  0 0 0 1]"),
        "t.pbrt:1:1: found a projective transformation, expected an affine one: numbers 4, 8, 12, 16 are 0 0 0 1");
    EXPECT_EQ(error_of("Rotate 30 0 0 0"), "t.pbrt:1:1: found Rotate about 0 0 0, expected an axis of some length");
    const std::string no_frame =
        "t.pbrt:1:1: found LookAt whose eye, look and up give no frame, expected two points apart, and an up direction "
        "that is not along the line between them";
    EXPECT_EQ(error_of("LookAt 1 2 3  1 2 3  0 1 0"), no_frame);
    EXPECT_EQ(error_of("LookAt 0 0 0  0 5 0  0 1 0"), no_frame);
    EXPECT_EQ(error_of("LookAt 0 0 0  0 5 0  0 0 0"), no_frame);
}

}  // namespace
}  // namespace emulsion
