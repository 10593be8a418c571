// Directives that change what later ones mean: the graphics state, and options.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pathtracer/scene_transform.h"
#include "scene_text.h"
#include "spectrum/colorimetry.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/rgb_space.h"

namespace emulsion {
namespace {

using ::testing::ElementsAre;
using testing::error_of;
using ::testing::IsEmpty;
using testing::parse;
using testing::parse_world;
using testing::world_error_of;

const std::string kLight = "LightSource \"infinite\"\n";

Imath::V3d centre_of(const Scene& scene, std::size_t shape) {
    return std::get<Sphere>(scene.shapes.at(shape).geometry).world_from_object.translation();
}
double radius_of(const Scene& scene, std::size_t shape) {
    return std::get<Sphere>(scene.shapes.at(shape).geometry).radius;
}
Spectrum reflectance_of(const Scene& scene, std::size_t shape) {
    const auto material = static_cast<std::size_t>(scene.shapes.at(shape).material);
    return std::get<Spectrum>(std::get<DiffuseMaterial>(scene.materials.at(material)).reflectance);
}
std::vector<std::string> warnings_of(const std::string& world) { return parse_world(kLight + world).warnings; }

TEST(TransformBlocks, SaveAllThatAttributeBlocksDo) {
    const Scene scene = parse_world(kLight + R"(TransformBegin Translate 1 2 3
        Material "diffuse" "blackbody reflectance" 9 Shape "sphere" TransformEnd Shape "sphere"
        TransformBegin TransformEnd)");
    EXPECT_EQ(centre_of(scene, 0), Imath::V3d(1, 2, 3));
    EXPECT_EQ(centre_of(scene, 1), Imath::V3d(0, 0, 0));
    EXPECT_EQ(reflectance_of(scene, 1), Spectrum(ConstantSpectrum{0.5}));
    EXPECT_THAT(scene.warnings, ElementsAre("t.pbrt:3:1: TransformBegin is deprecated, and means AttributeBegin: it "
                                            "saves more than the transformation"));
}

TEST(TransformBlocks, NestWithAttributeBlocks) {
    const Scene scene = parse_world(kLight + R"(AttributeBegin Translate 1 0 0 TransformBegin Translate 1 0 0
        Shape "sphere" TransformEnd Shape "sphere" AttributeEnd Shape "sphere")");
    EXPECT_EQ(centre_of(scene, 0).x, 2.0);
    EXPECT_EQ(centre_of(scene, 1).x, 1.0);
    EXPECT_EQ(centre_of(scene, 2).x, 0.0);
    // They are one kind of block to pbrt-v4.
    EXPECT_EQ(world_error_of("AttributeBegin TransformEnd TransformBegin AttributeEnd"), "(no error)");
    EXPECT_EQ(world_error_of("TransformEnd"),
              "t.pbrt:2:1: found TransformEnd without its TransformBegin, expected as many of one as the other");
    EXPECT_EQ(world_error_of("AttributeBegin TransformBegin AttributeEnd"),
              "t.pbrt:2:1: found AttributeBegin without its AttributeEnd, expected as many of one as the other");
    EXPECT_EQ(world_error_of("TransformBegin"),
              "t.pbrt:2:1: found TransformBegin without its TransformEnd, expected as many of one as the other");
}

TEST(CoordinateSystems, AreBroughtBackByName) {
    const Scene scene = parse(R"(Translate 0 0 -5 Camera "perspective" Translate 9 9 9 CoordinateSystem "before"
        WorldBegin LightSource "infinite"
        AttributeBegin Scale 2 2 2 Translate 1 0 0 CoordinateSystem "here" AttributeEnd
        AttributeBegin CoordSysTransform "here" Translate 1 0 0 Shape "sphere" AttributeEnd
        CoordSysTransform "camera" Shape "sphere" CoordSysTransform "world" Shape "sphere"
        CoordSysTransform "before" Shape "sphere")");
    // Places are counted from the camera, which stands at z = 5.
    EXPECT_EQ(centre_of(scene, 0), Imath::V3d(4, 0, -5));
    EXPECT_EQ(centre_of(scene, 1), Imath::V3d(0, 0, 0));
    EXPECT_EQ(centre_of(scene, 2), Imath::V3d(0, 0, -5));
    EXPECT_EQ(centre_of(scene, 3), Imath::V3d(9, 9, -1));
}

TEST(CoordinateSystems, AnUnknownOneIsWarnedOf) {
    const Scene scene = parse_world(kLight +
                                    "Translate 1 0 0 CoordinateSystem \"lamp\" CoordSysTransform \"lump\" "
                                    "Shape \"sphere\"");
    EXPECT_EQ(centre_of(scene, 0).x, 1.0);
    EXPECT_THAT(scene.warnings,
                ElementsAre("t.pbrt:3:59: unknown coordinate system \"lump\": the transformation stays as "
                            "it is (nearest known name: \"lamp\")"));
}

TEST(ActiveTransform, NothingMoves) {
    const std::string taken = kLight + R"(ActiveTransform StartTime Translate 1 0 0 ActiveTransform EndTime
        Translate 1 0 0 ActiveTransform All Translate 1 0 0 Shape "sphere")";
    EXPECT_EQ(centre_of(parse_world(taken), 0).x, 2.0);
    EXPECT_EQ(error_of("TransformTimes 0 1 WorldBegin ActiveTransform All"), "(no error)");

    const std::string moving = "ActiveTransform EndTime Translate 1 0 0\nActiveTransform All ";
    const std::string rests =
        " that moves while the shutter is open, expected one at rest: ActiveTransform StartTime "
        "and EndTime may not differ here";
    EXPECT_EQ(world_error_of(moving + "Shape \"sphere\""), "t.pbrt:3:27: found a shape" + rests);
    EXPECT_EQ(world_error_of("ObjectBegin \"o\" ObjectEnd " + moving + "ObjectInstance \"o\""),
              "t.pbrt:3:21: found an instance" + rests);
    EXPECT_EQ(error_of(moving + "Camera \"perspective\""), "t.pbrt:2:28: found a camera" + rests);
    EXPECT_EQ(world_error_of("ActiveTransform Half"),
              "t.pbrt:2:17: found unknown transformation \"Half\", expected a known one (nearest known name: \"All\")");
    EXPECT_EQ(world_error_of("ActiveTransform \"All\""),
              "t.pbrt:2:17: found the string \"All\", expected All, StartTime or EndTime after ActiveTransform");
    EXPECT_EQ(world_error_of("ActiveTransform EndTime Scale 0 1 1"),
              "t.pbrt:2:25: found a singular transformation, expected one that maps space to space, neither flattened "
              "nor overflowing");

    // Lights that move rest where they start, as in pbrt-v4.
    const Scene lamp = parse_world(moving + "LightSource \"point\" ActiveTransform All");
    EXPECT_EQ(std::get<PointLight>(lamp.lights[0]).position, Imath::V3d(0, 0, 0));
    EXPECT_THAT(lamp.warnings, ElementsAre("t.pbrt:3:33: the light is taken to rest where it is as the shutter opens"));
    // Blocks save what is active, and WorldBegin sets it back.
    EXPECT_EQ(world_error_of("AttributeBegin ActiveTransform EndTime AttributeEnd Translate 1 0 0 Shape \"sphere\""),
              "(no error)");
    EXPECT_EQ(error_of("ActiveTransform EndTime Translate 1 0 0 WorldBegin Translate 1 0 0 Shape \"sphere\""),
              "(no error)");
}

TEST(Attributes, GiveParametersToWhatFollows) {
    const Scene scene = parse_world(R"(Attribute "shape" "float radius" 3
        Attribute "light" "float scale" 2 Attribute "material" "spectrum reflectance" [ 400 1 700 1 ]
        LightSource "point" LightSource "point" "float scale" 5
        Material "diffuse" Shape "sphere" Material "diffuse" "spectrum reflectance" [ 400 .5 700 .5 ]
        Shape "sphere" "float radius" 4
        AttributeBegin Attribute "shape" "float radius" 7 Shape "sphere" AttributeEnd Shape "sphere"
        MakeNamedMaterial "m" "string type" "diffuse" NamedMaterial "m" Shape "sphere"
        AreaLightSource "diffuse" Shape "sphere")");
    EXPECT_EQ(
        std::get<PointLight>(scene.lights[1]).intensity.scale / std::get<PointLight>(scene.lights[0]).intensity.scale,
        2.5);
    EXPECT_EQ(radius_of(scene, 0), 3.0);
    EXPECT_EQ(radius_of(scene, 1), 4.0);  // its own parameters win
    EXPECT_EQ(radius_of(scene, 2), 7.0);  // and the later of two
    EXPECT_EQ(radius_of(scene, 3), 3.0);  // blocks save them
    EXPECT_EQ(reflectance_of(scene, 0), Spectrum(PiecewiseLinearSpectrum({{400, 700}, {1, 1}})));
    EXPECT_EQ(reflectance_of(scene, 1), Spectrum(PiecewiseLinearSpectrum({{400, 700}, {0.5, 0.5}})));
    EXPECT_EQ(reflectance_of(scene, 4), Spectrum(PiecewiseLinearSpectrum({{400, 700}, {1, 1}})));
    const double unscaled =
        parse_world("AreaLightSource \"diffuse\" Shape \"sphere\"").shapes[0].area_light->radiance.scale;
    EXPECT_DOUBLE_EQ(scene.shapes[5].area_light->radiance.scale, 2.0 * unscaled);
}

TEST(Attributes, AreOnlyTakenByThoseWhoKnowThem) {
    // A trianglemesh has no radius, and media and textures have nothing to do with shapes.
    EXPECT_THAT(warnings_of(R"(Attribute "shape" "float radius" 3 "float alpha" 1 Attribute "medium" "float g" 1
        Attribute "texture" "float scale" 2 Shape "trianglemesh" "point3 P" [ 0 0 0 1 0 0 0 1 0 ])"),
                IsEmpty());
    // What is wrong with one is found when somebody takes it.
    EXPECT_EQ(world_error_of("Attribute \"shape\" \"float radius\" -1\nShape \"sphere\""),
              "t.pbrt:2:34: found -1 for parameter \"radius\" of shape \"sphere\", expected a number above 0");
    EXPECT_EQ(world_error_of("Attribute \"shape\" \"float alpha\" .5\nShape \"sphere\""),
              "t.pbrt:2:33: found 0.5 for parameter \"alpha\" of shape \"sphere\", expected 1 (others are known to "
              "pbrt-v4 and not yet supported here)");
    EXPECT_EQ(world_error_of("Attribute \"shapes\" \"float radius\" 1"),
              "t.pbrt:2:11: found unknown attribute target \"shapes\", expected a known one (nearest known name: "
              "\"shape\")");
    EXPECT_EQ(world_error_of("Attribute \"shape\" \"float radius\""),
              "t.pbrt:2:33: found the end of the file, expected a number");
}

TEST(Alpha, OneIsOpaque) {
    for (const std::string shape : {R"("sphere")", R"("trianglemesh" "point3 P" [ 0 0 0 1 0 0 0 1 0 ])",
                                    R"("bilinearmesh" "point3 P" [ 0 0 0 1 0 0 0 1 0 1 1 0 ])"}) {
        EXPECT_THAT(warnings_of("Shape " + shape + " \"float alpha\" 1"), IsEmpty());
        EXPECT_THAT(world_error_of("Shape " + shape + " \"float alpha\" 0.5"),
                    ::testing::HasSubstr("expected 1 (others are known to pbrt-v4 and not yet supported here)"));
        EXPECT_THAT(world_error_of("Shape " + shape + " \"texture alpha\" \"leaf\""),
                    ::testing::HasSubstr("found type \"texture\" of parameter \"alpha\""));
    }
}

TEST(Media, NoneIsTaken) {
    EXPECT_EQ(error_of("MediumInterface \"\" WorldBegin MediumInterface \"\" \"\" Shape \"sphere\""), "(no error)");
    EXPECT_EQ(world_error_of("MediumInterface \"\" \"fog\""),
              "t.pbrt:2:20: found the medium \"fog\", expected \"\": media are not supported here");
    EXPECT_EQ(world_error_of("MediumInterface \"fog\" \"\""),
              "t.pbrt:2:17: found the medium \"fog\", expected \"\": media are not supported here");
}

// --- Colour spaces

XYZd seen(const Scene& scene, std::size_t shape, std::string_view space) {
    return xyz_of_reflectance(reflectance_of(scene, shape), illuminant_of(rgb_space(space)));
}

void expect_near(const XYZd& found, const XYZd& expected, double tolerance) {
    EXPECT_NEAR(found.x, expected.x, tolerance);
    EXPECT_NEAR(found.y, expected.y, tolerance);
    EXPECT_NEAR(found.z, expected.z, tolerance);
}

TEST(ColorSpaces, ReflectancesHaveTheirColourInThem) {
    struct Named {
        std::string name, space;
    };
    for (const Named& named : {Named{"srgb", "sRGB"}, Named{"rec2020", "Rec2020"}, Named{"dci-p3", "Display_P3"},
                               Named{"aces2065-1", "ACES2065_1_AP0"}, Named{"Rec2020", "Rec2020"}}) {
        const Scene scene = parse_world("ColorSpace \"" + named.name + "\" " + kLight +
                                        R"(Material "diffuse" "rgb reflectance" [ .3 .4 .25 ] Shape "sphere")");
        const Matrix3 xyz_from = xyz_from_rgb(rgb_space(named.space));
        const auto [x, y, z] = xyz_from * std::array{0.3, 0.4, 0.25};
        SCOPED_TRACE(named.name);
        expect_near(seen(scene, 0, named.space), {x, y, z}, 1e-3);
    }
}

TEST(ColorSpaces, LightsHaveTheirColourInThem) {
    const Scene scene = parse_world(R"(ColorSpace "rec2020" LightSource "infinite" "rgb L" [ .2 .7 .1 ]
        ColorSpace "aces2065-1" LightSource "infinite" LightSource "infinite" "rgb L" [ .5 .6 .4 ])");
    const auto xyz = [&](std::size_t light) {
        const ScaledSpectrum& radiance = std::get<UniformInfiniteLight>(scene.lights.at(light)).radiance;
        const XYZd unscaled = xyz_of_radiance(radiance.spectrum);
        return XYZd{unscaled.x * radiance.scale, unscaled.y * radiance.scale, unscaled.z * radiance.scale};
    };
    const auto expected = [](std::string_view space, const std::array<double, 3>& rgb) {
        const auto [x, y, z] = xyz_from_rgb(rgb_space(space)) * rgb;
        return XYZd{x, y, z};
    };
    expect_near(xyz(0), expected("Rec2020", {0.2, 0.7, 0.1}), 2e-3);
    expect_near(xyz(1), expected("ACES2065_1_AP0", {1.0, 1.0, 1.0}), 2e-3);  // D60, and not D65
    expect_near(xyz(2), expected("ACES2065_1_AP0", {0.5, 0.6, 0.4}), 2e-3);
}

TEST(ColorSpaces, AreSavedByBlocksAndKeptByWorldBegin) {
    const std::string grey = " Material \"diffuse\" \"rgb reflectance\" [ .1 .5 .1 ] Shape \"sphere\" ";
    const Scene scene =
        parse("ColorSpace \"rec2020\" WorldBegin " + kLight + grey + "AttributeBegin ColorSpace \"srgb\"" + grey +
              "AttributeEnd" + grey + "Attribute \"material\" \"rgb reflectance\" [ .1 .5 .1 ] " +
              "ColorSpace \"srgb\" Material \"diffuse\" Shape \"sphere\"");
    EXPECT_NE(reflectance_of(scene, 0), reflectance_of(scene, 1));
    EXPECT_EQ(reflectance_of(scene, 0), reflectance_of(scene, 2));
    EXPECT_EQ(reflectance_of(scene, 0), reflectance_of(scene, 3));  // the space is that of the Attribute
    EXPECT_EQ(world_error_of("ColorSpace \"rec2021\""),
              "t.pbrt:2:12: found unknown colour space \"rec2021\", expected a known one (nearest known name: "
              "\"rec2020\")");
}

// --- Options

TEST(Options, ThoseThatMatter) {
    EXPECT_TRUE(parse_world("").jitter.pixel);
    EXPECT_TRUE(parse_world("").jitter.wavelength);
    const Scene scene = parse(R"(Option "disablepixeljitter" true Option "bool disable-wavelength_Jitter" [ true ]
        Option "seed" 7 WorldBegin)");
    EXPECT_FALSE(scene.jitter.pixel);
    EXPECT_FALSE(scene.jitter.wavelength);
    EXPECT_EQ(scene.sampler_seed, 7);
    EXPECT_TRUE(parse(R"(Option "disablepixeljitter" true Option "disablepixeljitter" false WorldBegin)").jitter.pixel);
    // The sampler's own seed wins, wherever it stands.
    EXPECT_EQ(parse(R"(Sampler "zsobol" "integer seed" 3 Option "seed" 7 WorldBegin)").sampler_seed, 3);
    EXPECT_EQ(parse(R"(Sampler "zsobol" Option "integer seed" 7 WorldBegin)").sampler_seed, 7);
}

TEST(Options, OthersAreNamedInWarnings) {
    EXPECT_THAT(warnings_of(R"(Option "forcediffuse" true)"),
                ElementsAre("t.pbrt:3:8: option \"forcediffuse\" has no effect: materials are taken as they are"));
    EXPECT_THAT(warnings_of(R"(Option "bool wavefront" true)"),
                ElementsAre("t.pbrt:3:8: option \"wavefront\" has no effect: it changes no picture"));
    EXPECT_THAT(warnings_of(R"(Option "forcediffuse" false Option "rendercoordsys" "world"
                                Option "displacementedgescale" 2.5)"),
                ElementsAre("t.pbrt:3:36: option \"rendercoordsys\" has no effect: it changes no picture",
                            "t.pbrt:4:40: option \"displacementedgescale\" has no effect: nothing is displaced here"));
}

TEST(Options, RefusesWhatIsNone) {
    EXPECT_EQ(error_of("Option \"sead\" 3"),
              "t.pbrt:1:8: found unknown option \"sead\", expected a known one (nearest known name: \"seed\")");
    EXPECT_EQ(error_of("Option \"seed\" 1.5"),
              "t.pbrt:1:15: found \"1.5\", expected a whole number of at most 32 bits");
    EXPECT_EQ(error_of("Option \"seed\""), "t.pbrt:1:14: found the end of the file, expected a number");
    EXPECT_EQ(error_of("Option \"disablepixeljitter\" 1"), "t.pbrt:1:29: found \"1\", expected true or false");
    EXPECT_EQ(error_of("Option \"msereferenceout\" true"), "t.pbrt:1:26: found \"true\", expected a string");
    EXPECT_EQ(error_of("Option \"seed\" [ 1 2 ]"), "t.pbrt:1:19: found \"2\", expected a \"]\" after one value");
    EXPECT_EQ(error_of("Option \"\" 1").substr(0, 35), "t.pbrt:1:8: found unknown option \"\"");
}

}  // namespace
}  // namespace emulsion
