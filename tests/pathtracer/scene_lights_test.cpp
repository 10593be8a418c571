#include "pathtracer/scene_lights.h"

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "pathtracer/scene_transform.h"
#include "scene_text.h"
#include "spectrum/colorimetry.h"
#include "spectrum/named_spectra.h"
#include "spectrum/reflectance_weights.h"
#include "support/png_bytes.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatEq;
using testing::parse_world;
using testing::png_bytes;
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

// --- Spot lights

TEST(SceneLights, SpotLightsHaveTheDefaultsOfPbrt) {
    const auto spot = only_light<SpotLight>("LightSource \"spot\"");
    EXPECT_EQ(spot.position, Imath::V3d(0, 0, 0));
    EXPECT_NEAR(spot.cos_none, std::cos(30.0 * kPi / 180.0), 1e-12);
    EXPECT_NEAR(spot.cos_full, std::cos(25.0 * kPi / 180.0), 1e-12);
    EXPECT_EQ((Imath::V3d(0, 0, 5) * spot.light_from_world).normalized(), Imath::V3d(0, 0, 1));
    expect_photometric(spot.intensity, 1.0, "spot");
}

TEST(SceneLights, SpotLightsStandInTheCurrentSpace) {
    const auto spot = only_light<SpotLight>(
        R"(Translate 1 2 3 Rotate 90 0 0 1 Scale 4 4 4 LightSource "spot" "point from" [1 0 0] "point to" [1 2 0])");
    EXPECT_LT((spot.position - Imath::V3d(1, 6, 3)).length(), 1e-12);
    // y of object space is -x of the world; along it the light shines.
    const Imath::V3d axis = (Imath::V3d(-1, 0, 0) * spot.light_from_world).normalized();
    EXPECT_LT((axis - Imath::V3d(0, 0, 1)).length(), 1e-12);
    EXPECT_NEAR((Imath::V3d(0, 1, 0) * spot.light_from_world).normalized().z, 0.0, 1e-12);
}

TEST(SceneLights, StretchedSpotLightsHaveTheConeOfTheirOwnSpace) {
    // At (1, 0, 3) in the world, (1, 0, 1) in light space: at 45 degrees there.
    const auto spot = only_light<SpotLight>(R"(Scale 1 1 3 LightSource "spot")");
    EXPECT_NEAR((Imath::V3d(1, 0, 3) * spot.light_from_world).normalized().z, std::sqrt(0.5), 1e-12);
}

TEST(SceneLights, PowerOfASpotLightIsThatOfItsCone) {
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

TEST(SceneLights, ASpotLightMayFadeOverMoreThanItsConeAsInPbrt) {
    const auto spot = only_light<SpotLight>(R"(LightSource "spot" "float coneangle" 20 "float conedeltaangle" 25)");
    EXPECT_DOUBLE_EQ(spot.cos_full, std::cos(5.0 * kPi / 180.0));
    EXPECT_DOUBLE_EQ(spot.cos_none, std::cos(20.0 * kPi / 180.0));
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

TEST(SceneLights, RefusesWhatIsNoSpotLight) {
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

// --- Pictures as lights

/// A world with a picture file beside it.
class SceneImageLights : public ::testing::Test {
  protected:
    SceneImageLights() {
        write_text(folder_.file("even.png"),
                   png_bytes({.width = 64, .height = 64}, std::vector<int>(3 * 64 * 64, 255)));
        write_text(folder_.file("wide.png"), png_bytes({.width = 2, .height = 1}, std::vector<int>(6, 255)));
        write_text(folder_.file("black.png"), png_bytes({}, std::vector<int>(3, 0)));
    }
    [[nodiscard]] Scene parse(const std::string& parameters, const std::string& before = "") const {
        return parse_scene("WorldBegin\n" + before + "LightSource \"infinite\" " + parameters,
                           folder_.path() / "t.pbrt");
    }
    [[nodiscard]] ImageInfiniteLight light(const std::string& parameters, const std::string& before = "") const {
        return std::get<ImageInfiniteLight>(parse(parameters, before).lights.at(0));
    }
    [[nodiscard]] std::string error(const std::string& parameters, const std::string& before = "") const {
        try {
            static_cast<void>(parse(parameters, before));
        } catch (const SceneError& e) {
            return std::string(e.what()).substr(folder_.path().string().size() + 1);
        }
        return "(no error)";
    }
    TemporaryFolder folder_;
};

TEST_F(SceneImageLights, ScaleIsTheLuminanceOfAWhiteTexel) {
    const ImageInfiniteLight even = light(R"("string filename" "even.png" "float scale" 7)");
    expect_photometric(even.illuminant, 7.0, "scale");
    EXPECT_EQ(even.illuminant.spectrum, named_spectrum("stdillum-D65").value());
    EXPECT_EQ((*even.texels)(3, 4), (RGB{1, 1, 1}));
    const Scene scene = parse(R"("string filename" "even.png")");
    EXPECT_EQ(scene.files, std::vector<std::filesystem::path>{folder_.path() / "even.png"});
}

TEST_F(SceneImageLights, IlluminanceIsReckonedAsInPbrt) {
    // An even picture of luminance 1 gives pi lux. pbrt-v4 takes that for pi/2, summed over texels: their
    // centres' cosines have a mean of 1/4 but for one row of texels along the horizon, 1/64.
    const ImageInfiniteLight even = light(R"("string filename" "even.png" "float illuminance" 10 "float scale" 3)");
    EXPECT_NEAR(photometric(even.illuminant), 30.0 / (kPi / 2.0), 30.0 / (kPi / 2.0) / 64);
}

TEST_F(SceneImageLights, AnIlluminanceOfZeroIsNone) {
    EXPECT_EQ(light(R"("string filename" "even.png" "float illuminance" 0)").illuminant,
              light(R"("string filename" "even.png")").illuminant);
}

TEST_F(SceneImageLights, PicturesShineInTheSpaceOfTheirChromaticities) {
    const auto write = [&](const std::string& space) {
        Image<XYZ> xyz(1, 1);
        const auto p = xyz_from_rgb(rgb_space(space)) * std::array{0.5, 0.25, 2.0};
        xyz(0, 0) = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
        write_exr(folder_.file("x.exr"), xyz, {}, {.space = space});
        return parse(R"("string filename" "x.exr" "float scale" 7)", "ColorSpace \"dci-p3\"\n");
    };
    const Scene scene = write("ACES2065_1_AP0");
    const auto aces = std::get<ImageInfiniteLight>(scene.lights.at(0));
    EXPECT_EQ(aces.space, ColorSpace::aces2065_1);
    EXPECT_EQ(aces.illuminant.spectrum, Spectrum(illuminant_of(rgb_space("ACES2065_1_AP0"))));
    expect_photometric(aces.illuminant, 7.0, "scale");
    EXPECT_NEAR((*aces.texels)(0, 0).b, 2.0, 1e-5);
    EXPECT_TRUE(scene.warnings.empty());

    const Scene other = write("Adobe_RGB_1998");
    EXPECT_EQ(std::get<ImageInfiniteLight>(other.lights.at(0)).space, ColorSpace::srgb);
    ASSERT_EQ(other.warnings.size(), 1u);
    EXPECT_EQ(
        other.warnings[0].substr(folder_.path().string().size() + 1),
        "t.pbrt:3:42: picture \"x.exr\": its chromaticities are those of no space that is known: taken as sRGB, as "
        "in pbrt-v4");
}

TEST_F(SceneImageLights, ThePictureTurnsWithTheCurrentSpace) {
    const ImageInfiniteLight turned =
        light(R"("string filename" "even.png")", "Translate 9 9 9 Rotate 90 1 0 0 Scale 3 3 -3\n");
    const auto towards = [&](const Imath::V3d& in_light) {
        return transform_vector(turned.world_from_light, in_light);
    };
    EXPECT_LT((towards({1, 0, 0}) - Imath::V3d(1, 0, 0)).length(), 1e-12);
    EXPECT_LT((towards({0, 1, 0}) - Imath::V3d(0, 0, 1)).length(), 1e-12);
    EXPECT_LT((towards({0, 0, 1}) - Imath::V3d(0, 1, 0)).length(), 1e-12);
}

TEST_F(SceneImageLights, NegativeComponentsAreWarnedOf) {
    const std::filesystem::path path = folder_.file("negative.pfm");
    Image<XYZ> xyz(2, 2);
    xyz(0, 1) = {-1, -1, -1};
    xyz(1, 1) = {0.9505f, 1, 1.089f};
    write_pfm(path, xyz);
    const Scene scene = parse(R"("string filename" "negative.pfm")");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].substr(folder_.path().string().size() + 1),
              "t.pbrt:2:42: 1 texels have a negative component, which is taken for 0");
    EXPECT_EQ((*std::get<ImageInfiniteLight>(scene.lights.at(0)).texels)(0, 1), (RGB{0, 0, 0}));
}

TEST_F(SceneImageLights, RefusesWhatIsNoLight) {
    EXPECT_EQ(
        error(R"("string filename" "wide.png")"),
        "t.pbrt:2:42: found a picture of 2 x 1 texels, expected a square one, of all directions in the equal-area "
        "mapping");
    EXPECT_EQ(error(R"("string filename" "no.exr")"),
              "t.pbrt:2:42: found picture \"no.exr\" (No such file or directory), expected one that can be read");
    EXPECT_EQ(error(R"("string filename" "even.png" "rgb L" [1 1 1])"),
              "t.pbrt:2:53: found an \"L\" beside a \"filename\", expected one of the two");
    EXPECT_EQ(error(R"("string filename" "black.png" "float illuminance" 1)"),
              "t.pbrt:2:42: found a picture without light from above, expected some, for an \"illuminance\"");
    EXPECT_EQ(error(R"("string filename" "even.png")", "Scale 1 2 1 "),
              "t.pbrt:2:25: found the picture of an infinite light that is stretched or skewed, expected a "
              "transformation that rotates, mirrors, scales alike in all directions and moves");
    EXPECT_EQ(error(R"("string filename" "even.png" "float scale" 1e300)"),
              "t.pbrt:2:13: found a light scaled by 2.77112e+293, expected one that single precision holds");
    EXPECT_EQ(
        error(R"("string filename" "even.png" "point portal" [0 0 0 1 0 0 1 1 0 0 1 0])"),
        "t.pbrt:2:53: found parameter \"portal\" of light source \"infinite\", expected a supported one (known to "
        "pbrt-v4 and not yet supported here; supported: L, scale, illuminance, filename)");
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
