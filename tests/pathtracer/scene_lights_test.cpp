#include "pathtracer/scene_lights.h"

#include <string>
#include <type_traits>
#include <variant>

#include <gtest/gtest.h>

#include "scene_lights_fixture.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using testing::parse_world;
using testing::world_error_of;

TEST(SceneLights, ScaleIsPhotometricWhateverTheSpectrum) {
    for (const std::string spectrum :
         {"", "\"spectrum L\" [400 0 500 8 600 15.6 700 18.4]", "\"spectrum L\" [400 0 500 80 600 156 700 184]",
          "\"blackbody L\" 2700", "\"spectrum L\" \"stdillum-F11\"", "\"spectrum L\" [550 3 555 0]"}) {
        const std::string list = spectrum + " \"float scale\" 15";
        expect_photometric(square_light(list).radiance, 15.0, list);
        expect_photometric(only_light<DistantLight>("LightSource \"distant\" " + list).irradiance, 15.0, list);
        expect_photometric(only_light<UniformInfiniteLight>("LightSource \"infinite\" " + list).radiance, 15.0, list);
    }
    expect_photometric(only_light<PointLight>(R"(LightSource "point" "blackbody I" 5000 "float scale" 3)").intensity,
                       3.0, "point");
    expect_photometric(only_light<PointLight>("LightSource \"point\"").intensity, 1.0, "default");
}

TEST(SceneLights, AnRgbLightKeepsItsLuminance) {
    // The fitted spectrum has the colour to rounding in the uplift's own sums over 1 nm; 0.1% covers the difference.
    const auto y_of = [](const std::string& rgb) {
        return photometric(
            only_light<UniformInfiniteLight>("LightSource \"infinite\" \"rgb L\" [" + rgb + "]").radiance);
    };
    EXPECT_NEAR(y_of("1 1 1"), 1.0, 1e-3);
    EXPECT_NEAR(y_of("3 3 3"), 3.0, 3e-3);
    EXPECT_NEAR(y_of("0.4 0.45 0.5"), 0.2126 * 0.4 + 0.7152 * 0.45 + 0.0722 * 0.5, 1e-3);
    EXPECT_EQ(y_of("0 0 0"), 0.0);
}

TEST(SceneLights, LinesNarrowerThanANanometreAreLights) {
    expect_photometric(only_light<UniformInfiniteLight>(
                           "LightSource \"infinite\" \"spectrum L\" [589.2 0 589.5 1 589.8 0] \"float scale\" 7")
                           .radiance,
                       7.0, "sodium");
}

TEST(SceneLights, PowerAndIlluminanceMultiplyWithScale) {
    const std::string scale = " \"float scale\" 2";
    expect_photometric(only_light<PointLight>("LightSource \"point\" \"float power\" 100" + scale).intensity,
                       2.0 * 100.0 / (4.0 * kPi), "point");
    expect_photometric(only_light<DistantLight>("LightSource \"distant\" \"float illuminance\" 100" + scale).irradiance,
                       200.0, "distant");
    expect_photometric(
        only_light<UniformInfiniteLight>("LightSource \"infinite\" \"float illuminance\" 100" + scale).radiance,
        200.0 / kPi, "infinite");
}

TEST(SceneLights, APowerOrIlluminanceThatIsNotAboveZeroIsNone) {
    for (const std::string value : {"0", "-1", "-7"}) {
        const auto same = [&](const std::string& light, const std::string& parameter) {
            const Scene plain = parse_world(light);
            const Scene given = parse_world(light + " \"float " + parameter + "\" " + value);
            return plain.lights.at(0).index() == given.lights.at(0).index() &&
                   std::visit(
                       [&](const auto& l) {
                           const auto& other = std::get<std::decay_t<decltype(l)>>(given.lights.at(0));
                           if constexpr (requires { l.intensity; }) return l.intensity == other.intensity;
                           if constexpr (requires { l.irradiance; }) return l.irradiance == other.irradiance;
                           if constexpr (requires { l.radiance; }) return l.radiance == other.radiance;
                           return false;
                       },
                       plain.lights.at(0));
        };
        EXPECT_TRUE(same("LightSource \"point\"", "power")) << value;
        EXPECT_TRUE(same("LightSource \"spot\"", "power")) << value;
        EXPECT_TRUE(same("LightSource \"distant\"", "illuminance")) << value;
        EXPECT_TRUE(same("LightSource \"infinite\"", "illuminance")) << value;
        const std::string lamp = "AreaLightSource \"diffuse\" ";
        EXPECT_EQ(
            parse_world(lamp + "\"float power\" " + value + " Shape \"sphere\"").shapes.at(0).area_light->radiance,
            parse_world(lamp + "Shape \"sphere\"").shapes.at(0).area_light->radiance)
            << value;
    }
}

TEST(SceneLights, PointAndDistantLightsFollowTheTransformation) {
    const auto point =
        only_light<PointLight>(R"(Translate 1 0 0 Scale 2 2 2 LightSource "point" "point3 from" [1 2 3])");
    EXPECT_EQ(point.position, Imath::V3d(3, 4, 6));

    const auto towards = [](const std::string& text) { return only_light<DistantLight>(text).to_light; };
    EXPECT_EQ(towards("LightSource \"distant\""), Imath::V3d(0, 0, -1));
    EXPECT_EQ(towards(R"(Translate 9 9 9 LightSource "distant" "point from" [0 4 0] "point to" [0 1 0])"),
              Imath::V3d(0, 1, 0));
    const Imath::V3d turned =
        towards(R"(Rotate 90 0 0 1 LightSource "distant" "point3 from" [2 0 0] "point3 to" [1 0 0])");
    EXPECT_NEAR(turned.x, 0.0, 1e-15);
    EXPECT_NEAR(turned.y, 1.0, 1e-15);
}

TEST(SceneLights, NoLightIsWarnedOf) {
    const Scene scene = parse_world("Shape \"sphere\"");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0], "t.pbrt:1:1: there is no light: the picture will be black");
    EXPECT_TRUE(parse_world("LightSource \"infinite\"").warnings.empty());
}

TEST(SceneLights, RefusesWhatMakesNoLight) {
    EXPECT_EQ(
        world_error_of("LightSource \"infinite\" \"float scale\" -1"),
        "t.pbrt:2:38: found -1 for parameter \"scale\" of light source \"infinite\", expected 0 or a number above");
    EXPECT_EQ(world_error_of("LightSource \"infinite\" \"spectrum L\" [400 0 700 0]"),
              "t.pbrt:2:38: found a light spectrum without visible light, expected one whose luminance is above 0 and "
              "finite");
    EXPECT_EQ(world_error_of("LightSource \"infinite\" \"spectrum L\" [100 1 200 1]"),
              "t.pbrt:2:38: found a light spectrum without visible light, expected one whose luminance is above 0 and "
              "finite");
    EXPECT_EQ(world_error_of("LightSource \"infinite\" \"float scale\" 1e60"),
              "t.pbrt:2:13: found a light scaled by 1.38556e+53, expected one that single precision holds");
    // The scale alone would fit.
    EXPECT_EQ(world_error_of("LightSource \"infinite\" \"spectrum L\" [400 1e10 700 1e10] \"float scale\" 1e44"),
              "t.pbrt:2:13: found a light scaled by 1.37099e+29, expected one that single precision holds");
    EXPECT_EQ(
        world_error_of(R"(LightSource "distant" "point3 from" [1 2 3] "point3 to" [1 2 3])"),
        "t.pbrt:2:13: found a distant light whose \"from\" and \"to\" give no direction, expected two points apart "
        "from each other");
    EXPECT_EQ(world_error_of(R"(LightSource "point" "point3 from" [1e60 2 3])"),
              "t.pbrt:2:13: found a light at (1e+60, 2, 3), expected coordinates from -1e15 to 1e15 in world space");
    EXPECT_EQ(world_error_of(R"(LightSource "point" "point3 from" [1 2 3 4])"),
              "t.pbrt:2:21: found 4 values for parameter \"from\" of light source \"point\", expected 3");
}

}  // namespace
}  // namespace emulsion
