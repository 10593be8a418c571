#include "pathtracer/scene_shapes.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/scene_mesh.h"
#include "pathtracer/surface.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using testing::only_mesh;
using testing::parse_world;
using testing::world_error_of;
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle in z = 0 whose edges' cross product is along +z.
const std::string kTriangle = R"(Shape "trianglemesh" "point3 P" [0 0 0  1 0 0  0 1 0] )";

/// The z of the geometric normal amid the mesh's first triangle.
float normal_z(const TriangleMesh& mesh) { return surface_point(mesh, {.u = 0.25f, .v = 0.25f}).geometric_normal.z; }

TEST(SceneShapes, TriangleMesh) {
    const TriangleMesh mesh = only_mesh(parse_world(R"(Translate 1 2 3 Scale 2 2 2
        Shape "trianglemesh" "integer indices" [0 1 2  2 1 3] "point P" [0 0 0  1 0 0  0 1 0  1 1 0]
        "point2 uv" [0 0 1 0 0 1 1 1] "vector3 S" [1 0 0 1 0 0 1 0 0 1 0 0])"));
    EXPECT_THAT(mesh.position,
                ElementsAre(Imath::V3f(1, 2, 3), Imath::V3f(3, 2, 3), Imath::V3f(1, 4, 3), Imath::V3f(3, 4, 3)));
    EXPECT_THAT(mesh.triangle, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 1, 3}));
    EXPECT_TRUE(mesh.normal.empty());
    EXPECT_FALSE(mesh.flip_normal);
    EXPECT_THAT(mesh.uv, ElementsAre(Imath::V2f(0, 0), Imath::V2f(1, 0), Imath::V2f(0, 1), Imath::V2f(1, 1)));
    EXPECT_THAT(mesh.tangent,
                ElementsAre(Imath::V3f(2, 0, 0), Imath::V3f(2, 0, 0), Imath::V3f(2, 0, 0), Imath::V3f(2, 0, 0)));
}

TEST(SceneShapes, OneTriangleNeedsNoIndices) {
    EXPECT_THAT(only_mesh(parse_world(kTriangle)).triangle, ElementsAre(Triangle{0, 1, 2}));
}

TEST(SceneShapes, NormalsFaceAsInPbrt) {
    EXPECT_GT(normal_z(only_mesh(parse_world(kTriangle))), 0.0);
    EXPECT_LT(normal_z(only_mesh(parse_world("ReverseOrientation " + kTriangle))), 0.0);
    EXPECT_GT(normal_z(only_mesh(parse_world("ReverseOrientation ReverseOrientation " + kTriangle))), 0.0);
    // A mirror that keeps z keeps the normal: it swaps the handedness of the edges, and so turns them once more.
    EXPECT_GT(normal_z(only_mesh(parse_world("Scale -1 1 1 " + kTriangle))), 0.0);
    EXPECT_LT(normal_z(only_mesh(parse_world("ReverseOrientation Scale -1 1 1 " + kTriangle))), 0.0);
    EXPECT_GT(normal_z(only_mesh(parse_world("Scale -1 -1 1 " + kTriangle))), 0.0);
    EXPECT_LT(normal_z(only_mesh(parse_world("Scale 1 1 -1 " + kTriangle))), 0.0);
    EXPECT_LT(normal_z(only_mesh(parse_world("Rotate 180 1 0 0 " + kTriangle))), 0.0);
    EXPECT_GT(normal_z(only_mesh(parse_world("AttributeBegin ReverseOrientation AttributeEnd " + kTriangle))), 0.0);
}

TEST(SceneShapes, GivenNormalsDecideTheSide) {
    const std::string up = R"("normal N" [0 0 2  0 1 2  1 0 2])", down = R"("normal3 N" [0 0 -2  0 1 -2  1 0 -2])";
    EXPECT_GT(normal_z(only_mesh(parse_world(kTriangle + up))), 0.0);
    EXPECT_LT(normal_z(only_mesh(parse_world(kTriangle + down))), 0.0);
    EXPECT_GT(normal_z(only_mesh(parse_world("ReverseOrientation " + kTriangle + down))), 0.0);
    EXPECT_GT(normal_z(only_mesh(parse_world("Scale -1 1 1 " + kTriangle + up))), 0.0);
    EXPECT_LT(normal_z(only_mesh(parse_world("Scale 1 1 -1 " + kTriangle + up))), 0.0);
}

TEST(SceneShapes, NormalsGoByTheInverseTransposeAndKeepTheirLength) {
    const std::string normals = R"("normal N" [0 0 2  0 1 2  1 0 2])";
    EXPECT_THAT(only_mesh(parse_world("Scale 2 1 4 " + kTriangle + normals)).normal,
                ElementsAre(Imath::V3f(0, 0, 0.5f), Imath::V3f(0, 1, 0.5f), Imath::V3f(0.5f, 0, 0.5f)));
    EXPECT_THAT(only_mesh(parse_world("ReverseOrientation Translate 5 5 5 " + kTriangle + normals)).normal,
                ElementsAre(Imath::V3f(0, 0, -2), Imath::V3f(0, -1, -2), Imath::V3f(-1, 0, -2)));
}

BilinearMesh only_patches(const Scene& scene) { return std::get<BilinearMesh>(scene.shapes.at(0).geometry); }

/// The z of the geometric normal amid the mesh's first patch.
float normal_z(const BilinearMesh& mesh) { return surface_point(mesh, 0, {0.5, 0.5}).geometric_normal.z; }

TEST(SceneShapes, BilinearMesh) {
    const std::string square = R"(Shape "bilinearmesh" "point3 P" [0 0 0  1 0 0  0 1 0  1 1 0])";
    const BilinearMesh mesh = only_patches(parse_world(square));
    EXPECT_THAT(mesh.patch, ElementsAre(std::array<std::uint32_t, 4>{0, 1, 2, 3}));
    EXPECT_TRUE(mesh.flat);
    EXPECT_GT(normal_z(mesh), 0.0);
    EXPECT_LT(normal_z(only_patches(parse_world("ReverseOrientation " + square))), 0.0);

    const BilinearMesh two = only_patches(parse_world(R"(Shape "bilinearmesh" "integer indices" [0 1 2 3  1 4 3 5]
        "point3 P" [0 0 0  1 0 0  0 1 0  1 1 0  2 0 0  2 1.5 0] "point2 uv" [0 0 0 0 0 0 0 0 0 0 0 0])"));
    EXPECT_EQ(two.patch.size(), 2u);
    EXPECT_EQ(two.uv.size(), 6u);
    EXPECT_TRUE(two.flat);
    const std::vector<double> areas = light_areas(two);
    EXPECT_NEAR(areas.at(0), 1.0, 1e-12);
    EXPECT_NEAR(areas.at(1), 1.25, 1e-12);
}

TEST(SceneShapes, PatchesAreFlatIfTheyAreConvexAndInAPlane) {
    const auto is_flat = [](const std::string& points) {
        return only_patches(parse_world("Shape \"bilinearmesh\" \"point3 P\" [" + points + "]")).flat;
    };
    EXPECT_FALSE(is_flat("0 0 0  1 0 0  0 1 0  1 1 .01"));
    EXPECT_TRUE(is_flat("0 0 0  1 0 0  0 1 0  1 1 1e-6"));
    EXPECT_FALSE(is_flat("0 0 0  1 0 0  0 1 0  .2 .2 0"));
    EXPECT_FALSE(is_flat("0 0 0  1 0 0  1 1 0  0 1 0"));  // corners in the order of a walk: a bow tie
    EXPECT_TRUE(is_flat("0 0 0  2 0 0  0 1 0  1 1 0"));   // a trapezium
    EXPECT_TRUE(is_flat("0 0 0  1 0 0  0 1 0  0 1 0"));   // a triangle
}

TEST(SceneShapes, PatchesWithoutAreaAreCounted) {
    const Scene scene = parse_world(R"(LightSource "infinite"
 Shape "bilinearmesh" "point3 P" [0 0 0  1 0 0  2 0 0  3 0 0])");
    EXPECT_THAT(scene.warnings, ElementsAre("t.pbrt:3:8: patches without area, left out: 1 of 1"));
    EXPECT_TRUE(scene.shapes.empty());
}

TEST(SceneShapes, Sphere) {
    const Scene scene = parse_world(R"(Translate 1 2 3 Shape "sphere" "float radius" 2.5
        ReverseOrientation Shape "sphere" "float zmin" -1 "float zmax" 7 "float phimax" 400
        Scale -1 1 1 Shape "sphere" "float zmin" .5 "float zmax" -.25 "float phimax" 90)");
    const auto sphere = [&](std::size_t i) { return std::get<Sphere>(scene.shapes.at(i).geometry); };
    EXPECT_EQ(sphere(0).radius, 2.5);
    EXPECT_EQ(sphere(0).world_from_object.translation(), Imath::V3d(1, 2, 3));
    EXPECT_FALSE(sphere(0).flip_normal);
    EXPECT_TRUE(PreparedSphere(sphere(0)).whole);
    EXPECT_EQ(sphere(1).radius, 1.0);
    EXPECT_TRUE(sphere(1).flip_normal);
    EXPECT_TRUE(PreparedSphere(sphere(1)).whole);
    EXPECT_FALSE(sphere(2).flip_normal);  // turned, and turned back by the mirror
    EXPECT_EQ(sphere(2).z_min, -0.25);
    EXPECT_EQ(sphere(2).z_max, 0.5);
    EXPECT_DOUBLE_EQ(sphere(2).phi_max, 0.5 * M_PI);
}

TEST(SceneShapes, DiskAndCylinder) {
    const Scene scene = parse_world(R"(Translate 1 2 3 Shape "disk" Shape "cylinder" ReverseOrientation
        Shape "disk" "float radius" 3 "float innerradius" 1 "float height" -2 "float phimax" 180
        Shape "cylinder" "float radius" 3 "float zmin" 4 "float zmax" -2 "float phimax" 90)");
    const auto disk = [&](std::size_t i) { return std::get<Disk>(scene.shapes.at(i).geometry); };
    const auto cylinder = [&](std::size_t i) { return std::get<Cylinder>(scene.shapes.at(i).geometry); };
    EXPECT_EQ(disk(0).world_from_object.translation(), Imath::V3d(1, 2, 3));
    EXPECT_EQ(disk(0).radius, 1.0);
    EXPECT_EQ(disk(0).inner_radius, 0.0);
    EXPECT_FALSE(disk(0).flip_normal);
    EXPECT_EQ(cylinder(1).z_min, -1.0);
    EXPECT_EQ(cylinder(1).z_max, 1.0);
    EXPECT_EQ(disk(2).height, -2.0);
    EXPECT_TRUE(disk(2).flip_normal);
    EXPECT_NEAR(light_areas(disk(2)).at(0), 4.0 * M_PI, 1e-12);
    EXPECT_EQ(cylinder(3).z_min, -2.0);
    EXPECT_NEAR(light_areas(cylinder(3)).at(0), 9.0 * M_PI, 1e-12);
}

TEST(SceneShapes, QuadricsWithoutAreaAreLeftOut) {
    for (const char* const shape :
         {R"("sphere" "float zmin" 2)", R"("sphere" "float phimax" 0)", R"("disk" "float innerradius" 1)",
          R"("disk" "float phimax" -10)", R"("cylinder" "float zmin" 1)"}) {
        const Scene scene = parse_world(std::string("LightSource \"infinite\" Shape ") + shape);
        EXPECT_TRUE(scene.shapes.empty()) << shape;
        EXPECT_THAT(scene.warnings, ElementsAre(::testing::HasSubstr(" without area, left out"))) << shape;
    }
}

TEST(SceneShapes, TrianglesWithoutAreaAreCounted) {
    const Scene scene = parse_world(R"(LightSource "infinite"
 Shape "trianglemesh" "integer indices" [0 1 1  0 1 2  0 1 3] "point3 P" [0 0 0  1 0 0  0 1 0  2 0 0]
 Shape "trianglemesh" "point3 P" [0 0 0  1 0 0  2 0 0])");
    EXPECT_THAT(scene.warnings, ElementsAre("t.pbrt:3:8: triangles without area, left out: 2 of 3",
                                            "t.pbrt:4:8: triangles without area, left out: 1 of 1"));
    EXPECT_EQ(scene.shapes.size(), 1u);
    EXPECT_THAT(only_mesh(scene).triangle, ElementsAre(Triangle{0, 1, 2}));
}

struct BadShape {
    std::string text, message;
};

TEST(SceneShapes, RefusesWhatIsNoShape) {
    const BadShape bad[] = {
        {R"(Shape "trianglemesh" "integer indices" [0 1 2])",
         "7: found shape \"trianglemesh\" without positions, expected a parameter \"P\""},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0 1 1 1])",
         "7: found 4 positions and no parameter \"indices\", expected \"indices\", or exactly 3 positions"},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1])",
         "22: found 8 values for parameter \"P\" of shape \"trianglemesh\", expected a multiple of 3"},
        {R"(Shape "trianglemesh" "point3 P" [])", "34: found \"]\" right after \"[\", expected at least one value"},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0] "integer indices" [0 1])",
         "53: found 2 values for parameter \"indices\", expected a multiple of 3"},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0] "integer indices" [0 1 2 2 3 0])",
         "80: found the index 3, expected one from 0 to 2, as \"P\" has 3 positions"},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0] "integer indices" [0 -1 2])",
         "74: found the index -1, expected one from 0 to 2, as \"P\" has 3 positions"},
        {R"(Shape "bilinearmesh" "point3 P" [0 0 0 1 0 0 0 1 0])",
         "7: found 3 positions and no parameter \"indices\", expected \"indices\", or exactly 4 positions"},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0] "normal N" [0 0 1])",
         "53: found parameter \"N\" of length 1, expected length 3, that of \"P\""},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0] "point2 uv" [0 0 1 1])",
         "53: found parameter \"uv\" of length 2, expected length 3, that of \"P\""},
        {R"(Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1.1e15 0])",
         "46: found (0, 1.1e+15, 0) in world space for parameter \"P\", expected coordinates from -1e15 to 1e15 in "
         "world "
         "space"},
        {R"(Shape "trianglemesh" "vector3 P" [0 0 0 1 0 0 0 1 0])",
         "22: found type \"vector3\" of parameter \"P\" of shape \"trianglemesh\", expected point3"},
        {R"(Shape "sphere" "float radius" -1)",
         "31: found -1 for parameter \"radius\" of shape \"sphere\", expected a number above 0"},
        {R"(Shape "sphere" "float radius" 1e39)",
         "7: found a sphere that reaches to 1e+39, expected coordinates from -1e15 to 1e15 in world space"},
        {R"(Translate 0 9e14 0 Shape "sphere" "float radius" 2e14)",
         "26: found a sphere that reaches to 1.1e+15, expected coordinates from -1e15 to 1e15 in world space"},
        {R"(Scale 1e-120 1e-120 1e-120 Shape "sphere")",
         "34: found a sphere under a transformation without inverse, expected another one"},
        {R"(Scale 1e-120 1e-120 1e-120 Shape "trianglemesh" "normal N" [0 0 1 0 0 1 0 0 1] "point3 P" [0 0 0 1 0 0 0 1 0])",
         "49: found normals under a transformation without inverse, expected another one"},
        {R"(Shape "disk" "float innerradius" -1)",
         "34: found -1 for parameter \"innerradius\" of shape \"disk\", expected 0 or a number above"},
        {R"(Scale 1e14 1e14 1 Shape "disk" "float radius" 20)",
         "25: found a disk that reaches to 2e+15, expected coordinates from -1e15 to 1e15 in world space"},
        {R"(Shape "cylinder" "float zmax" 1e16)",
         "7: found a cylinder that reaches to 1e+16, expected coordinates from -1e15 to 1e15 in world space"},
        {R"(Shape "plymesh")", "7: found shape \"plymesh\" without a file, expected a parameter \"filename\""},
        {R"(Shape "sphere" "float alpha" 0)",
         "30: found 0 for parameter \"alpha\" of shape \"sphere\", expected 1 (others are known to pbrt-v4 and not yet "
         "supported here)"},
    };
    for (const BadShape& shape : bad) EXPECT_EQ(world_error_of(shape.text), "t.pbrt:2:" + shape.message) << shape.text;
}

}  // namespace
}  // namespace emulsion
