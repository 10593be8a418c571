// AreaLightSource, and the shapes that shine.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/scene_lights.h"
#include "scene_lights_fixture.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatEq;
using testing::parse_world;

TEST(SceneAreaLights, PowerIsThatOfEachBilinearPatch) {
    const std::string power = "\"float power\" 100";
    expect_photometric(square_light(power + " \"float scale\" 2").radiance, 200.0 / kPi, "area");
    expect_photometric(square_light(power + " \"bool twosided\" true").radiance, 50.0 / kPi, "two-sided");
    expect_photometric(square_light(power, "Scale 2 3 7").radiance, 100.0 / (6.0 * kPi), "scaled");
    EXPECT_THAT(square_light(power).triangle_scale, ElementsAre(1.0f));
    EXPECT_TRUE(square_light("\"float scale\" 2").triangle_scale.empty());
}

/// As in pbrt-v4, where every triangle is a light of its own: the small ones shine brighter.
TEST(SceneAreaLights, PowerIsThatOfEachTriangle) {
    const Scene scene = parse_world(R"(AreaLightSource "diffuse" "float power" 100
        Shape "trianglemesh" "integer indices" [0 1 2 1 3 2] "point3 P" [0 0 0  1 0 0  0 2 0  4 6 0])");
    const AreaLight& light = scene.shapes.at(0).area_light.value();
    expect_photometric(light.radiance, 100.0 / kPi, "the first, of area 1");
    EXPECT_THAT(light.triangle_scale, ElementsAre(FloatEq(1.0f), FloatEq(1.0f / 6.0f)));
}

/// cd/m^2 of a sphere of 100 lm.
double sphere_luminance(const std::string& transform) {
    const Scene scene =
        parse_world(transform + R"( AreaLightSource "diffuse" "float power" 100 Shape "sphere" "float radius" 2)");
    return photometric(scene.shapes.at(0).area_light.value().radiance);
}

/// As in pbrt-v4, which takes a sphere's area before its transformation.
TEST(SceneAreaLights, PowerIsSpreadOverTheSphereBeforeItsTransformation) {
    EXPECT_NEAR(sphere_luminance("") * kPi * 16.0 * kPi, 100.0, 1e-5);
    EXPECT_NEAR(sphere_luminance("Scale -3 3 3 Rotate 20 1 2 3") * kPi * 16.0 * kPi, 100.0, 1e-5);
    EXPECT_NEAR(sphere_luminance("Scale 1 .5 1") * kPi * 16.0 * kPi, 100.0, 1e-5);
}

TEST(SceneAreaLights, AreaLightsBelongToTheShapesOfTheirBlock) {
    const std::string sphere = " Shape \"sphere\" ";
    const Scene scene = parse_world(sphere + "AttributeBegin AreaLightSource \"diffuse\" \"bool twosided\" true" +
                                    sphere + sphere + "AttributeEnd" + sphere);
    ASSERT_EQ(scene.shapes.size(), 4u);
    EXPECT_FALSE(scene.shapes[0].area_light);
    EXPECT_TRUE(scene.shapes[1].area_light.value().two_sided);
    EXPECT_TRUE(scene.shapes[2].area_light);
    EXPECT_FALSE(scene.shapes[3].area_light);
    EXPECT_TRUE(scene.warnings.empty());
}

}  // namespace
}  // namespace emulsion
