// Texture coordinates and tangents against the formulas of pbrt-v4's shapes.

#include "pathtracer/surface_coordinates.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scene_text.h"

namespace emulsion::testing {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Met {
    Hit hit;
    SurfacePoint point;
    Imath::V2f uv;
    Imath::V3f tangent;
};

/// What a ray meets of a scene text.
Met meet(const std::string& world, const Imath::V3f& origin, const Imath::V3f& direction) {
    const PreparedScene scene(parse_world(world), 1);
    const Ray ray{origin, direction};
    Met met;
    scene.accelerator().intersect({&ray, 1}, {&met.hit, 1});
    if (met.hit.shape == Hit::kNone) throw std::runtime_error("the ray met nothing");
    met.point = surface_point(scene, ray, met.hit);
    met.uv = surface_uv(scene, met.hit, met.point);
    met.tangent = surface_tangent(scene, met.hit, met.point);
    return met;
}

void expect_near(const Imath::V2f& found, const Imath::V2f& expected) {
    EXPECT_NEAR(found.x, expected.x, 1e-6f);
    EXPECT_NEAR(found.y, expected.y, 1e-6f);
}

void expect_near(const Imath::V3f& found, const Imath::V3f& expected) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-6f) << "component " << i;
}

const std::string kTriangle = R"(Shape "trianglemesh" "point3 P" [0 0 5  4 0 5  0 2 5] )";

TEST(SurfaceCoordinates, TrianglesInterpolateTheirOwn) {
    const Met met = meet(kTriangle + R"("point2 uv" [10 20  10 24  13 20])", {1.0f, 0.5f, 0}, {0, 0, 1});
    expect_near(met.uv, {10.75f, 21.0f});  // barycentric coordinates 1/4 and 1/4
    expect_near(met.tangent, {0, 1, 0});   // u grows from the first corner to the third
}

TEST(SurfaceCoordinates, TrianglesWithoutAnyHaveThoseOfPbrt) {
    const Met met = meet(kTriangle, {1.0f, 0.5f, 0}, {0, 0, 1});
    expect_near(met.uv, {0.5f, 0.25f});
    expect_near(met.tangent, {1, 0, 0});
    // Normals that face the other way don't change the order of the corners.
    const Met turned = meet(kTriangle + R"("normal N" [0 0 -1  0 0 -1  0 0 -1])", {1.0f, 0.25f, 0}, {0, 0, 1});
    expect_near(turned.uv, {0.375f, 0.125f});
    expect_near(turned.point.geometric_normal, {0, 0, -1});
}

TEST(SurfaceCoordinates, TangentsOfTheMeshComeFirst) {
    const Met met =
        meet("Rotate 90 0 0 1 " + kTriangle + R"("vector3 S" [3 0 7  3 0 7  3 0 7])", {-0.5f, 1, 0}, {0, 0, 1});
    expect_near(met.tangent, {0, 1, 0});  // turned with the shape, and laid into the surface
}

TEST(SurfaceCoordinates, DegenerateOnesGiveSomeTangent) {
    for (const char* const uv : {"1 1 1 1 1 1", "0 0 1 1 2 2", "0 0 1e-20 0 0 1e-20"}) {
        const Met met = meet(kTriangle + "\"point2 uv\" [" + uv + "]", {1.0f, 0.5f, 0}, {0, 0, 1});
        EXPECT_NEAR(met.tangent.length(), 1.0f, 1e-6f) << uv;
        EXPECT_NEAR(met.tangent.dot(met.point.shading_normal), 0.0f, 1e-6f) << uv;
    }
}

TEST(SurfaceCoordinates, SpheresHaveLongitudeAndLatitudeFromBelow) {
    const std::string sphere = R"(Translate 0 0 10 Shape "sphere" "float radius" 2)";
    const float half = 2.0f * std::sqrt(0.5f);
    // From the side of -y, at 45 degrees above the equator and a longitude of 3/4 of the turn.
    const Met met = meet(sphere, {0, -5, 10.0f + half}, {0, 1, 0});
    expect_near(met.uv, {0.75f, 0.75f});
    expect_near(met.tangent, {1, 0, 0});
    expect_near(meet(sphere, {5, 1e-4f, 10}, {-1, 0, 0}).uv, {1e-4f / (4 * kPi), 0.5f});
    const Met south = meet(sphere, {0, 0, 0}, {0, 0, 1});
    EXPECT_NEAR(south.uv.y, 0.0f, 1e-6f);
    EXPECT_NEAR(south.tangent.dot(south.point.shading_normal), 0.0f, 1e-6f);
    EXPECT_NEAR(south.tangent.length(), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace emulsion::testing
