#include "pathtracer/scene_lights.h"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"
#include "spectrum/colorimetry.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatEq;
using testing::parse_world;
using testing::world_error_of;

constexpr double kPi = std::numbers::pi;

/// cd/m^2 of a radiance, cd of an intensity, lux of an irradiance.
double photometric(const ScaledSpectrum& light) { return light.scale * xyz_of_radiance(light.spectrum).y; }

template <class T>
T only_light(const std::string& text) {
    return std::get<T>(parse_world(text).lights.at(0));
}

/// The area light of a unit square.
AreaLight square_light(const std::string& area_light, const std::string& before_shape = "") {
    const Scene scene = parse_world("AreaLightSource \"diffuse\" " + area_light + " " + before_shape +
                                    R"( Shape "bilinearmesh" "point3 P" [0 0 0  1 0 0  0 1 0  1 1 0])");
    return scene.shapes.at(0).area_light.value();
}

// 1e-6: the normalisation is exact for straight lines, and good to 1e-9 for the smooth ones.
void expect_photometric(const ScaledSpectrum& light, double expected, const std::string& what) {
    EXPECT_NEAR(photometric(light) / expected, 1.0, 1e-6) << what;
}

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

TEST(SceneLights, PowerIsThatOfEachBilinearPatch) {
    const std::string power = "\"float power\" 100";
    expect_photometric(square_light(power + " \"float scale\" 2").radiance, 200.0 / kPi, "area");
    expect_photometric(square_light(power + " \"bool twosided\" true").radiance, 50.0 / kPi, "two-sided");
    expect_photometric(square_light(power, "Scale 2 3 7").radiance, 100.0 / (6.0 * kPi), "scaled");
    EXPECT_THAT(square_light(power).triangle_scale, ElementsAre(1.0f));
    EXPECT_TRUE(square_light("\"float scale\" 2").triangle_scale.empty());
}

TEST(SceneLights, LinesNarrowerThanANanometreAreLights) {
    expect_photometric(only_light<UniformInfiniteLight>(
                           "LightSource \"infinite\" \"spectrum L\" [589.2 0 589.5 1 589.8 0] \"float scale\" 7")
                           .radiance,
                       7.0, "sodium");
}

/// As in pbrt-v4, where every triangle is a light of its own: the small ones shine brighter.
TEST(SceneLights, PowerIsThatOfEachTriangle) {
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
TEST(SceneLights, PowerIsSpreadOverTheSphereBeforeItsTransformation) {
    EXPECT_NEAR(sphere_luminance("") * kPi * 16.0 * kPi, 100.0, 1e-5);
    EXPECT_NEAR(sphere_luminance("Scale -3 3 3 Rotate 20 1 2 3") * kPi * 16.0 * kPi, 100.0, 1e-5);
    EXPECT_NEAR(sphere_luminance("Scale 1 .5 1") * kPi * 16.0 * kPi, 100.0, 1e-5);
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

TEST(SceneLights, AreaLightsBelongToTheShapesOfTheirBlock) {
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
    EXPECT_EQ(world_error_of("AreaLightSource \"diffuse\" \"float power\" 0"),
              "t.pbrt:2:41: found 0 for parameter \"power\" of area light \"diffuse\", expected a number above 0");
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
    EXPECT_EQ(
        world_error_of(R"(LightSource "infinite" "string filename" "sky.exr")"),
        "t.pbrt:2:24: found parameter \"filename\" of light source \"infinite\", expected a supported one (known to "
        "pbrt-v4 and not yet supported here; supported: L, scale, illuminance)");
}

}  // namespace
}  // namespace emulsion
