#include "pathtracer/scene_spectra.h"

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene_text.h"
#include "spectrum/colorimetry.h"
#include "spectrum/named_spectra.h"

namespace emulsion {
namespace {

using testing::parse_world;
using testing::world_error_of;

Spectrum reflectance_of(const Scene& scene, std::size_t shape = 0) {
    const int material = scene.shapes.at(shape).material;
    return std::get<Spectrum>(
        std::get<DiffuseMaterial>(scene.materials.at(static_cast<std::size_t>(material))).reflectance);
}

Spectrum reflectance(const std::string& parameter) {
    return reflectance_of(parse_world("Material \"diffuse\" " + parameter + " Shape \"sphere\""));
}

TEST(SceneSpectra, TabulatedValues) {
    const Spectrum expected = PiecewiseLinearSpectrum{{400, 500.5, 700}, {0.25, 1, 0}};
    EXPECT_EQ(reflectance(R"("spectrum reflectance" [400 .25 500.5 1 700 0])"), expected);
}

TEST(SceneSpectra, RgbReflectancesLookLikeTheirColour) {
    const XYZd seen =
        xyz_of_reflectance(reflectance(R"("rgb reflectance" [0.2 0.5 0.1])"), named_spectrum("stdillum-D65").value());
    // Linear sRGB to XYZ, IEC 61966-2-1.
    EXPECT_NEAR(seen.x, 0.4124 * 0.2 + 0.3576 * 0.5 + 0.1805 * 0.1, 1e-3);
    EXPECT_NEAR(seen.y, 0.2126 * 0.2 + 0.7152 * 0.5 + 0.0722 * 0.1, 1e-3);
    EXPECT_NEAR(seen.z, 0.0193 * 0.2 + 0.1192 * 0.5 + 0.9505 * 0.1, 1e-3);
}

TEST(SceneSpectra, BlackbodiesAndNamedSpectra) {
    const Scene scene = parse_world(R"(LightSource "infinite" "blackbody L" [2042]
        LightSource "infinite" "spectrum L" "stdillum-A")");
    EXPECT_EQ(std::get<UniformInfiniteLight>(scene.lights[0]).radiance.spectrum, Spectrum(BlackbodySpectrum{2042}));
    EXPECT_EQ(std::get<UniformInfiniteLight>(scene.lights[1]).radiance.spectrum, named_spectrum("stdillum-A").value());
    EXPECT_EQ(reflectance(R"("blackbody reflectance" 3000)"), Spectrum(BlackbodySpectrum{3000}));
}

TEST(SceneSpectra, FilesAreFoundBesideTheScene) {
    const std::filesystem::path folder = std::filesystem::path(EMULSION_SOURCE_DIR) / "tests/data/scenes";
    const Scene scene = read_scene(folder / "paint-from-file.pbrt");
    EXPECT_EQ(reflectance_of(scene), Spectrum(PiecewiseLinearSpectrum({{400, 550, 700}, {0.1, 0.5, 0.2}})));

    const auto error_of_file = [&](const std::string& name) -> std::string {
        const std::string text = "WorldBegin\nMaterial \"diffuse\" \"spectrum reflectance\" \"" + name + "\"";
        try {
            static_cast<void>(parse_scene(text, folder / "x.pbrt"));
        } catch (const SceneError& error) {
            return std::string(error.what()).substr(folder.string().size() + 1);
        }
        return "(no error)";
    };
    EXPECT_EQ(error_of_file("paint.spd"), "(no error)");
    EXPECT_EQ(error_of_file("odd.spd"),
              "odd.spd:3:1: found the end of the file after 3 numbers, expected pairs of wavelength and value");
    EXPECT_EQ(
        error_of_file("falling.spd"),
        "falling.spd:2:1: found the wavelength 400 nm, expected wavelengths that rise from pair to pair, here one "
        "above 500 nm");
    EXPECT_EQ(error_of_file("none.spd"),
              "x.pbrt:2:43: found spectrum \"none.spd\", expected a known one, or a file that can be read");
    EXPECT_EQ(error_of_file("."),
              "x.pbrt:2:43: found spectrum \".\" (is a folder, not a text file), expected a known one, or a file that "
              "can be read");
    EXPECT_EQ(
        error_of_file("glass-BK8"),
        "x.pbrt:2:43: found spectrum \"glass-BK8\", expected a known one, or a file that can be read (nearest known "
        "name: \"glass-BK7\")");
}

TEST(SceneSpectra, DefaultMaterial) {
    EXPECT_EQ(reflectance(""), Spectrum(ConstantSpectrum{0.5}));
    const Scene scene = parse_world("Shape \"sphere\" Shape \"sphere\"");
    EXPECT_EQ(reflectance_of(scene), Spectrum(ConstantSpectrum{0.5}));
    EXPECT_EQ(scene.shapes[0].material, scene.shapes[1].material);
}

const std::string kPaint = R"("string type" "diffuse" "spectrum reflectance" )";

TEST(SceneMaterials, NamedOnesMayBeUsedBeforeTheyAreMade) {
    const Scene scene = parse_world("NamedMaterial \"a\" Shape \"sphere\" MakeNamedMaterial \"b\" " + kPaint +
                                    "[400 .25 700 .25] MakeNamedMaterial \"a\" " + kPaint +
                                    "[400 1 700 1] NamedMaterial \"b\" Shape \"sphere\"");
    EXPECT_EQ(reflectance_of(scene, 0), Spectrum(PiecewiseLinearSpectrum({{400, 700}, {1, 1}})));
    EXPECT_EQ(reflectance_of(scene, 1), Spectrum(PiecewiseLinearSpectrum({{400, 700}, {0.25, 0.25}})));
}

TEST(SceneMaterials, AttributeBlocksSaveThem) {
    const Scene scene =
        parse_world("Material \"diffuse\" AttributeBegin Material \"diffuse\" \"blackbody reflectance\" 9 " +
                    std::string("Shape \"sphere\" AttributeEnd Shape \"sphere\""));
    EXPECT_EQ(reflectance_of(scene, 0), Spectrum(BlackbodySpectrum{9}));
    EXPECT_EQ(reflectance_of(scene, 1), Spectrum(ConstantSpectrum{0.5}));
}

TEST(SceneMaterials, RefusesWhatIsNoMaterial) {
    EXPECT_EQ(world_error_of("MakeNamedMaterial \"white\" " + kPaint + "[400 1 700 1]\n NamedMaterial \"whyte\""),
              "t.pbrt:3:16: found unknown named material \"whyte\", expected one that MakeNamedMaterial makes (nearest "
              "known name: \"white\")");
    EXPECT_EQ(
        world_error_of("NamedMaterial \"z\" NamedMaterial \"a\""),
        "t.pbrt:2:15: found unknown named material \"z\", expected one that MakeNamedMaterial makes (none is known)");
    EXPECT_EQ(world_error_of("MakeNamedMaterial \"a\" " + kPaint + "[400 1 700 1]\nMakeNamedMaterial \"a\" " + kPaint +
                             "[400 1 700 1]"),
              "t.pbrt:3:1: found a second material \"a\", expected each name only once (the first is at t.pbrt:2:1)");
    EXPECT_EQ(world_error_of("MakeNamedMaterial \"a\" \"rgb reflectance\" [1 1 1]"),
              "t.pbrt:2:19: found the material \"a\" without a type, expected a parameter \"string type\"");
    EXPECT_EQ(
        world_error_of("MakeNamedMaterial \"a\" \"string type\" \"hair\""),
        "t.pbrt:2:37: found material \"hair\", expected a supported one (known to pbrt-v4 and not yet supported here; "
        "supported: diffuse, conductor, dielectric, thindielectric, diffusetransmission, coateddiffuse, mix, "
        "interface)");
    EXPECT_EQ(world_error_of("MakeNamedMaterial \"a\" \"string type\" [\"diffuse\" \"mix\"]"),
              "t.pbrt:2:23: found 2 types of one material, expected 1");
    EXPECT_EQ(world_error_of("NamedMaterial white"),
              "t.pbrt:2:15: found \"white\", expected a string after NamedMaterial");
}

struct BadSpectrum {
    std::string parameter, message;
};

TEST(SceneSpectra, RefusesMalformedOnes) {
    const BadSpectrum bad[] = {
        {R"("rgb reflectance" [1 1])", "20: found 2 values for an rgb colour, expected 3"},
        {R"("rgb reflectance" [0 1.5 1])", "41: found 1.5, expected reflectances from 0 to 1"},
        {R"("rgb reflectance" [0 0 -.1])", "43: found -0.1, expected reflectances from 0 to 1"},
        {R"("blackbody reflectance" [3000 1])", "20: found 2 values for a blackbody, expected 1, its temperature"},
        {R"("blackbody reflectance" -1)", "44: found a temperature of -1 K, expected a number above 0"},
        {R"("spectrum reflectance" [400 1 700])",
         "20: found 3 numbers for a spectrum, expected pairs of wavelength and value"},
        {R"("spectrum reflectance" [400 0 400 1])",
         "50: found the wavelength 400 nm, expected wavelengths that rise from pair to pair, here one above 400 nm"},
        {R"("spectrum reflectance" [-1 0 400 1])",
         "44: found the wavelength -1 nm, expected wavelengths that rise from pair to pair, here one above 0 nm"},
        {R"("spectrum reflectance" ["stdillum-A" "stdillum-A"])", "20: found 2 names for one spectrum, expected 1"},
        {R"("spectrum reflectance" ["stdillum-A" 3])", "57: found \"3\", expected a string after a string, or \"]\""},
        {R"("spectrum reflectance" [3 "stdillum-A"])",
         "46: found the string \"stdillum-A\", expected a number, a string or \"]\""},
        {R"("spectrum reflectance" "stdillum-B")",
         "43: found spectrum \"stdillum-B\", expected a known one, or a file that can be read (nearest known name: "
         "\"stdillum-A\")"},
        {R"("float reflectance" .5)",
         "20: found type \"float\" of parameter \"reflectance\" of material \"diffuse\", expected rgb, blackbody, "
         "spectrum or texture"},
    };
    for (const BadSpectrum& spectrum : bad) {
        EXPECT_EQ(world_error_of("Material \"diffuse\" " + spectrum.parameter), "t.pbrt:2:" + spectrum.message)
            << spectrum.parameter;
    }
    EXPECT_EQ(world_error_of("LightSource \"infinite\" \"rgb L\" [1 -1 1]"),
              "t.pbrt:2:35: found -1, expected 0 or a number above");
    EXPECT_EQ(world_error_of("LightSource \"infinite\" \"spectrum L\" [400 1 500 -2]"),
              "t.pbrt:2:48: found -2 at 500 nm, expected 0 or a number above");
}

// As in pbrt-v4, which looks at what comes of them.
TEST(SceneSpectra, TabulatedReflectancesAreClamped) {
    const Scene scene = parse_world(R"(LightSource "infinite"
Material "diffuse" "spectrum reflectance" [400 0.5 500 1.5 600 -1 700 0.25])");
    EXPECT_THAT(scene.warnings,
                ::testing::ElementsAre("t.pbrt:3:44: reflectances from -1 to 1.5, of which what is left "
                                       "below 0 and above 1 is taken for 0 and 1"));
    const auto reflectance_of = [](const Scene& s) {
        return std::get<Spectrum>(std::get<DiffuseMaterial>(s.materials.back()).reflectance);
    };
    const Spectrum clamped = reflectance_of(scene);
    // The lines are clamped, not their ends: they meet 1 at 450 nm and 520 nm, and 0 at 560 nm and 680 nm.
    for (int lambda_nm = 400; lambda_nm <= 700; ++lambda_nm) {
        const double given = lambda_nm < 500   ? 0.5 + (lambda_nm - 400) / 100.0
                             : lambda_nm < 600 ? 1.5 - 2.5 * (lambda_nm - 500) / 100.0
                                               : -1.0 + 1.25 * (lambda_nm - 600) / 100.0;
        EXPECT_NEAR(eval(clamped, static_cast<double>(lambda_nm)), std::clamp(given, 0.0, 1.0), 1e-12) << lambda_nm;
    }
    // A lamp's spectrum is no reflectance, but what pbrt-v4 makes of one.
    EXPECT_EQ(eval(reflectance_of(parse_world(R"(Material "diffuse" "spectrum reflectance" "stdillum-A")")), 560.0),
              1.0);
    // A texture may make it less, and so may a scale.
    const Scene halved = parse_world(R"(Texture "t" "spectrum" "scale" "spectrum tex" [400 1.5 700 1.5] "float scale" .5
        Material "diffusetransmission" "spectrum reflectance" [400 1.5 700 1.5] "float scale" .5)");
    const auto& scale = std::get<ScaleTexture<ReflectanceParameter>>(halved.reflectance_textures.at(0));
    EXPECT_EQ(eval(std::get<Spectrum>(scale.texture), 550.0), 1.5);
    const auto& thin = std::get<DiffuseTransmissionMaterial>(halved.materials.at(0));
    EXPECT_EQ(eval(std::get<Spectrum>(thin.reflectance), 550.0), 1.5);
}

TEST(SceneSpectra, TellsUnsupportedNamesFromUnknownOnes) {
    const std::string name = "metal-MgO-eta";
    ASSERT_TRUE(is_known_to_pbrt(name));
    ASSERT_FALSE(named_spectrum(name));
    const std::string message = world_error_of("LightSource \"infinite\" \"spectrum L\" \"" + name + "\"");
    const std::string expected =
        "t.pbrt:2:37: found spectrum \"" + name +
        "\", expected a supported one (known to pbrt-v4 and not yet supported here; supported: ";
    EXPECT_EQ(message.substr(0, expected.size()), expected);
}

}  // namespace
}  // namespace emulsion
