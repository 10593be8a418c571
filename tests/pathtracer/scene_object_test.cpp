#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/prepared_scene.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using testing::parse;
using testing::parse_world;
using testing::world_error_of;

const std::string kLight = "LightSource \"infinite\"\n";

TEST(SceneObjects, AreShapesThatInstancesPlace) {
    // Objects have the transformation in force at ObjectBegin in them, and instances that of their own. Places in
    // objects are counted from where they begin.
    const Scene scene = parse_world(kLight + R"(Translate 1 0 0 ObjectBegin "ball" Scale 2 2 2
        Material "diffuse" "blackbody reflectance" 9 Shape "sphere" Shape "sphere" "float radius" 3 ObjectEnd
        ObjectBegin "empty" ObjectEnd
        Translate 0 5 0 ObjectInstance "ball" Identity ObjectInstance "ball" ObjectInstance "empty" Shape "sphere")");
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].name, "ball");
    ASSERT_EQ(scene.objects[0].shapes.size(), 2u);
    const auto& sphere = std::get<Sphere>(scene.objects[0].shapes[0].geometry);
    EXPECT_EQ(sphere.world_from_object, Imath::M44d(2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1));
    EXPECT_TRUE(scene.objects[1].shapes.empty());

    ASSERT_EQ(scene.instances.size(), 3u);
    EXPECT_EQ(scene.instances[0].object, 0);
    EXPECT_EQ(scene.instances[0].world_from_object.translation(), Imath::V3d(2, 5, 0));
    EXPECT_EQ(scene.instances[1].world_from_object.translation(), Imath::V3d(1, 0, 0));
    EXPECT_EQ(scene.instances[2].object, 1);
    // ObjectEnd brings the state back.
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_NE(scene.shapes[0].material, scene.objects[0].shapes[0].material);
    EXPECT_TRUE(scene.warnings.empty());
}

// However far away an object is made, its instance stands as exactly as a shape there.
TEST(SceneObjects, AreExactFarFromTheOrigin) {
    const Scene scene = parse(R"(Translate -1e7 0 0 Camera "perspective" WorldBegin LightSource "infinite"
        Translate 1e7 0 0 ObjectBegin "o" Shape "trianglemesh" "integer indices" [0 1 2]
        "point3 P" [0.125 0 0 0.375 0 0 0.125 0.25 3] ObjectEnd Identity ObjectInstance "o")");
    const auto& mesh = std::get<TriangleMesh>(scene.objects.at(0).shapes.at(0).geometry);
    EXPECT_EQ(mesh.position.at(0), Imath::V3f(0.125f, 0.0f, 0.0f));
    EXPECT_EQ(scene.instances.at(0).world_from_object, Imath::M44d());
}

TEST(SceneObjects, RefuseToBePlacedOutOfReach) {
    EXPECT_EQ(
        world_error_of("ObjectBegin \"o\" Shape \"sphere\" ObjectEnd Scale 1e-20 1 1e20 ObjectInstance \"o\""),
        "t.pbrt:2:76: found an instance whose transformation, or its inverse, reaches 1e+20, expected coordinates "
        "from -1e15 to 1e15 in world space");
}

// Nothing is no obstacle.
TEST(SceneObjects, MayBeAllThatThereIsAndEmpty) {
    const PreparedScene prepared(
        parse_world(kLight + "ObjectBegin \"a\" ObjectEnd ObjectInstance \"a\" ObjectInstance \"a\""), 1);
    EXPECT_EQ(prepared.accelerator().bounds_radius(), 0.0f);
}

TEST(SceneObjects, MayBeUsedBeforeTheyAreMade) {
    const Scene scene = parse_world(kLight +
                                    "ObjectInstance \"later\" ObjectBegin \"other\" ObjectEnd "
                                    "ObjectBegin \"later\" Shape \"sphere\" ObjectEnd");
    EXPECT_EQ(scene.instances.at(0).object, 1);
}

TEST(SceneObjects, CloseUpWhereInterfacesAreLeftOut) {
    const std::string gone = "AttributeBegin Material \"interface\" Shape \"sphere\" AttributeEnd ";
    const Scene scene = parse_world(kLight + gone + "ObjectBegin \"a\" " + gone + "Shape \"sphere\" " + gone +
                                    "ObjectEnd " + gone + "ObjectBegin \"b\" " + gone + "ObjectEnd Shape \"sphere\"");
    EXPECT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.objects.at(0).shapes.size(), 1u);
    EXPECT_TRUE(scene.objects.at(1).shapes.empty());
}

TEST(SceneObjects, GiveNoLight) {
    const Scene scene = parse_world(kLight +
                                    "AreaLightSource \"diffuse\"\nObjectBegin \"o\" Shape \"sphere\" ObjectEnd "
                                    "Shape \"sphere\"");
    EXPECT_FALSE(scene.objects.at(0).shapes.at(0).area_light);
    EXPECT_TRUE(scene.shapes.at(0).area_light);
    EXPECT_THAT(scene.warnings, ElementsAre("t.pbrt:4:23: a shape of an object gives no light, as in pbrt-v4: its "
                                            "AreaLightSource is left out"));
}

TEST(SceneObjects, RefusesWhatPbrtRefuses) {
    const std::string ball = "ObjectBegin \"ball\" Shape \"sphere\" ObjectEnd\n";
    EXPECT_EQ(world_error_of(ball + "ObjectInstance \"bell\""),
              "t.pbrt:3:16: found unknown object \"bell\", expected one that ObjectBegin makes (nearest known name: "
              "\"ball\")");
    EXPECT_EQ(world_error_of("ObjectInstance \"bell\""),
              "t.pbrt:2:16: found unknown object \"bell\", expected one that ObjectBegin makes (none is known)");
    EXPECT_EQ(world_error_of(ball + ball),
              "t.pbrt:3:1: found a second object \"ball\", expected each name only once (the first is at t.pbrt:2:1)");
    EXPECT_EQ(
        world_error_of("ObjectBegin \"a\"\nObjectBegin \"b\""),
        "t.pbrt:3:1: found ObjectBegin inside an object, expected the ObjectEnd of the ObjectBegin at t.pbrt:2:1");
    EXPECT_EQ(world_error_of(ball + "ObjectBegin \"a\" ObjectInstance \"ball\""),
              "t.pbrt:3:17: found ObjectInstance inside an object, expected it outside: objects are made of shapes "
              "only, as in pbrt-v4");
    EXPECT_EQ(world_error_of("ObjectEnd"),
              "t.pbrt:2:1: found ObjectEnd without its ObjectBegin, expected as many of one as the other");
    EXPECT_EQ(world_error_of("ObjectBegin \"a\""),
              "t.pbrt:2:1: found ObjectBegin without its ObjectEnd, expected as many of one as the other");
    EXPECT_EQ(world_error_of("ObjectBegin \"a\"\nAttributeBegin\nObjectEnd"),
              "t.pbrt:4:1: found ObjectEnd, expected the AttributeEnd of the AttributeBegin at t.pbrt:3:1");
    EXPECT_EQ(world_error_of("AttributeBegin\nObjectBegin \"a\"\nAttributeEnd"),
              "t.pbrt:4:1: found AttributeEnd, expected the ObjectEnd of the ObjectBegin at t.pbrt:3:1");
}

}  // namespace
}  // namespace emulsion
