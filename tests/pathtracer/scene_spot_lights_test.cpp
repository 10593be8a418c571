// LightSource "spot".

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pathtracer/scene_lights.h"
#include "scene_lights_fixture.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using testing::world_error_of;

TEST(SceneSpotLights, SpotLightsHaveTheDefaultsOfPbrt) {
    const auto spot = only_light<SpotLight>("LightSource \"spot\"");
    EXPECT_EQ(spot.position, Imath::V3d(0, 0, 0));
    EXPECT_NEAR(spot.cos_none, std::cos(30.0 * kPi / 180.0), 1e-12);
    EXPECT_NEAR(spot.cos_full, std::cos(25.0 * kPi / 180.0), 1e-12);
    EXPECT_EQ((Imath::V3d(0, 0, 5) * spot.light_from_world).normalized(), Imath::V3d(0, 0, 1));
    expect_photometric(spot.intensity, 1.0, "spot");
}

TEST(SceneSpotLights, SpotLightsStandInTheCurrentSpace) {
    const auto spot = only_light<SpotLight>(
        R"(Translate 1 2 3 Rotate 90 0 0 1 Scale 4 4 4 LightSource "spot" "point from" [1 0 0] "point to" [1 2 0])");
    EXPECT_LT((spot.position - Imath::V3d(1, 6, 3)).length(), 1e-12);
    // y of object space is -x of the world; along it the light shines.
    const Imath::V3d axis = (Imath::V3d(-1, 0, 0) * spot.light_from_world).normalized();
    EXPECT_LT((axis - Imath::V3d(0, 0, 1)).length(), 1e-12);
    EXPECT_NEAR((Imath::V3d(0, 1, 0) * spot.light_from_world).normalized().z, 0.0, 1e-12);
}

TEST(SceneSpotLights, StretchedSpotLightsHaveTheConeOfTheirOwnSpace) {
    // At (1, 0, 3) in the world, (1, 0, 1) in light space: at 45 degrees there.
    const auto spot = only_light<SpotLight>(R"(Scale 1 1 3 LightSource "spot")");
    EXPECT_NEAR((Imath::V3d(1, 0, 3) * spot.light_from_world).normalized().z, std::sqrt(0.5), 1e-12);
}

TEST(SceneSpotLights, PowerOfASpotLightIsThatOfItsCone) {
    const auto spot = only_light<SpotLight>(
        R"(LightSource "spot" "float coneangle" 60 "float conedeltaangle" 15 "float power" 100 "float scale" 3)");
    // The integral of the falloff over all directions.
    double solid_angle = 0.0;
    constexpr int kSteps = 100000;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = 0.5 + 0.5 * (i + 0.5) / kSteps;  // from cos 60 on
        const double edge = std::cos(45.0 * kPi / 180.0);
        const double t = std::min((cosine - 0.5) / (edge - 0.5), 1.0);
        solid_angle += 2.0 * kPi * 0.5 / kSteps * t * t * (3.0 - 2.0 * t);
    }
    expect_photometric(spot.intensity, 300.0 / solid_angle, "spot");
}

TEST(SceneSpotLights, ASpotLightMayFadeOverMoreThanItsConeAsInPbrt) {
    const auto spot = only_light<SpotLight>(R"(LightSource "spot" "float coneangle" 20 "float conedeltaangle" 25)");
    EXPECT_DOUBLE_EQ(spot.cos_full, std::cos(5.0 * kPi / 180.0));
    EXPECT_DOUBLE_EQ(spot.cos_none, std::cos(20.0 * kPi / 180.0));
}

TEST(SceneSpotLights, RefusesWhatIsNoSpotLight) {
    EXPECT_EQ(world_error_of(R"(LightSource "spot" "float coneangle" 181)"),
              "t.pbrt:2:38: found a cone of 181 degrees, expected at most 180 from the axis");
    EXPECT_EQ(
        world_error_of(R"(LightSource "spot" "float coneangle" 20 "float conedeltaangle" 41)"),
        "t.pbrt:2:13: found a cone of 20 degrees that fades over 41, expected a conedeltaangle of at most twice the "
        "coneangle: pbrt-v4 turns the cone inside out");
    EXPECT_EQ(world_error_of(R"(LightSource "spot" "float coneangle" 0)"),
              "t.pbrt:2:38: found 0 for parameter \"coneangle\" of light source \"spot\", expected a number above 0");
    EXPECT_EQ(world_error_of(R"(LightSource "spot" "point from" [1 2 3] "point to" [1 2 3])"),
              "t.pbrt:2:13: found a spot light whose \"from\" and \"to\" give no direction, expected two points apart "
              "from each other");
}

}  // namespace
}  // namespace emulsion
