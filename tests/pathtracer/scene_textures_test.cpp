#include "pathtracer/scene_textures.h"

#include <array>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "pathtracer/scene_transform.h"
#include "scene_text.h"
#include "support/png_bytes.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::parse_world;
using testing::png_bytes;
using testing::world_error_of;

Scene parse_in(const std::filesystem::path& folder, const std::string& world) {
    return parse_scene("WorldBegin\n" + world, folder / "t.pbrt");
}

/// The message for a world in a folder, without the folder.
std::string error_in(const std::filesystem::path& folder, const std::string& world) {
    try {
        static_cast<void>(parse_in(folder, world));
    } catch (const SceneError& error) {
        return std::string(error.what()).substr(folder.string().size() + 1);
    }
    return "(no error)";
}

double constant_of(const ReflectanceParameter& parameter) {
    return std::get<ConstantSpectrum>(std::get<Spectrum>(parameter)).value;
}

const ReflectanceParameter& last_reflectance(const Scene& scene) {
    return std::get<DiffuseMaterial>(scene.materials.back()).reflectance;
}

// --- Classes

TEST(SceneTextures, ConstantsAreNoTextures) {
    const Scene scene = parse_world(R"(Texture "grey" "spectrum" "constant" "spectrum value" [400 .25 700 .25]
        Material "diffuse" "texture reflectance" "grey"
        Texture "one" "spectrum" "constant"
        Material "diffuse" "texture reflectance" "one")");
    EXPECT_TRUE(scene.reflectance_textures.empty());
    EXPECT_EQ(std::get<Spectrum>(std::get<DiffuseMaterial>(scene.materials[0]).reflectance),
              Spectrum(PiecewiseLinearSpectrum({{400, 700}, {0.25, 0.25}})));
    EXPECT_EQ(constant_of(last_reflectance(scene)), 1.0);
}

TEST(SceneTextures, CheckerboardsHaveTheDefaultsOfPbrt) {
    const Scene scene = parse_world(R"(Texture "c" "spectrum" "checkerboard" "float uscale" 16 "float vdelta" -2
        Texture "f" "float" "checkerboard")");
    const auto& board = std::get<CheckerboardTexture<ReflectanceParameter>>(scene.reflectance_textures.at(0));
    EXPECT_EQ(constant_of(board.first), 1.0);
    EXPECT_EQ(constant_of(board.second), 0.0);
    const auto& mapping = std::get<UvMapping>(std::get<TextureMapping>(board.mapping));
    EXPECT_EQ(mapping.scale_u, 16.0);
    EXPECT_EQ(mapping.scale_v, 1.0);
    EXPECT_EQ(mapping.delta_u, 0.0);
    EXPECT_EQ(mapping.delta_v, -2.0);
    const auto& floats = std::get<CheckerboardTexture<FloatParameter>>(scene.float_textures.at(0));
    EXPECT_EQ(std::get<double>(floats.first), 1.0);
    EXPECT_EQ(std::get<double>(floats.second), 0.0);
}

TEST(SceneTextures, TexturesReferToTexturesBeforeThem) {
    const Scene scene = parse_world(R"(
        Texture "amount" "float" "checkerboard" "float tex1" .25
        Texture "a" "spectrum" "checkerboard"
        Texture "b" "spectrum" "mix" "texture tex1" "a" "texture amount" "amount"
        Material "diffuse" "texture reflectance" "b")");
    const auto& mix = std::get<MixTexture<ReflectanceParameter>>(scene.reflectance_textures.at(1));
    EXPECT_EQ(std::get<TextureIndex>(mix.first).index, 0);
    EXPECT_EQ(constant_of(mix.second), 1.0);
    EXPECT_EQ(std::get<TextureIndex>(mix.amount).index, 0);
    EXPECT_EQ(std::get<TextureIndex>(last_reflectance(scene)).index, 1);
}

TEST(SceneTextures, BothKindsHaveNamesOfTheirOwn) {
    const Scene scene = parse_world(R"(Texture "x" "float" "checkerboard" Texture "x" "spectrum" "checkerboard")");
    EXPECT_EQ(scene.float_textures.size(), 1u);
    EXPECT_EQ(scene.reflectance_textures.size(), 1u);
}

TEST(SceneTextures, NamesOutliveTheirBlock) {
    const Scene scene = parse_world(R"(AttributeBegin Texture "x" "spectrum" "constant" "rgb value" [0 0 0] AttributeEnd
        Material "diffuse" "texture reflectance" "x")");
    EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(SceneTextures, ScalesThatDoNothingDisappear) {
    const Scene scene =
        parse_world(R"(Texture "a" "spectrum" "checkerboard" Texture "b" "spectrum" "scale" "texture tex" "a"
        Texture "c" "spectrum" "scale" "texture tex" "b" "float scale" 1
        Material "diffuse" "texture reflectance" "c"
        Texture "f" "float" "constant" "float value" 3 Texture "g" "float" "scale" "texture tex" "f" "float scale" 2
        Texture "h" "float" "checkerboard" "texture tex1" "g")");
    EXPECT_EQ(scene.reflectance_textures.size(), 1u);
    EXPECT_EQ(std::get<TextureIndex>(last_reflectance(scene)).index, 0);
    ASSERT_EQ(scene.float_textures.size(), 1u);
    EXPECT_EQ(std::get<double>(std::get<CheckerboardTexture<FloatParameter>>(scene.float_textures[0]).first), 6.0);
}

TEST(SceneTextures, MappingsStandInTheCurrentSpace) {
    const Scene scene = parse_world(R"(Translate 1 2 3 Scale 2 2 2
        Texture "s" "float" "checkerboard" "string mapping" "spherical"
        Texture "c" "float" "checkerboard" "string mapping" "cylindrical"
        Texture "p" "float" "checkerboard" "string mapping" "planar" "vector v1" [0 0 2] "float udelta" .5)");
    const auto mapping = [&](std::size_t i) {
        return std::get<TextureMapping>(
            std::get<CheckerboardTexture<FloatParameter>>(scene.float_textures.at(i)).mapping);
    };
    const Imath::M44d texture_from_world = std::get<SphericalTextureMapping>(mapping(0)).texture_from_world;
    EXPECT_EQ(Imath::V3d(3, 2, 3) * texture_from_world, Imath::V3d(1, 0, 0));
    EXPECT_EQ(std::get<CylindricalTextureMapping>(mapping(1)).texture_from_world, texture_from_world);
    const auto planar = std::get<PlanarTextureMapping>(mapping(2));
    EXPECT_EQ(planar.texture_from_world, texture_from_world);
    EXPECT_EQ(planar.along_u, Imath::V3d(0, 0, 2));
    EXPECT_EQ(planar.along_v, Imath::V3d(0, 1, 0));
    EXPECT_EQ(planar.delta_u, 0.5);
    EXPECT_EQ(planar.delta_v, 0.0);
}

// --- Pictures

TEST(SceneTextures, PicturesAreFoundBesideTheScene) {
    const TemporaryFolder folder;
    write_text(folder.file("red.png"), png_bytes({}, std::array{255, 0, 0}));
    const std::string world = R"(Texture "t" "spectrum" "imagemap" "string filename" "red.png" "string wrap" "clamp"
        "string filter" "point" "float scale" .5 "bool invert" true "float uscale" 3)";
    const Scene scene = parse_in(folder.path(), world);
    const auto& texture = std::get<ImageTexture<RGB>>(scene.reflectance_textures.at(0));
    EXPECT_EQ(texture.image->texels(0, 0), (RGB{1, 0, 0}));
    EXPECT_EQ(texture.wrap, TextureWrap::clamp);
    EXPECT_EQ(texture.filter, TextureFilter::nearest);
    EXPECT_EQ(texture.scale, 0.5);
    EXPECT_TRUE(texture.invert);
    EXPECT_EQ(std::get<UvMapping>(texture.mapping).scale_u, 3.0);

    // They are part of what the scene is.
    EXPECT_EQ(scene.files, std::vector<std::filesystem::path>{folder.path() / "red.png"});
    write_text(folder.file("red.png"), png_bytes({}, std::array{254, 0, 0}));
    EXPECT_NE(parse_in(folder.path(), world).hash, scene.hash);
}

TEST(SceneTextures, PicturesHaveTheDefaultsOfPbrt) {
    const TemporaryFolder folder;
    write_text(folder.file("x.png"), png_bytes({}, std::array{255, 0, 0}));
    const Scene scene = parse_in(folder.path(), R"(Texture "t" "float" "imagemap" "string filename" "x.png")");
    const auto& texture = std::get<ImageTexture<float>>(scene.float_textures.at(0));
    EXPECT_EQ(texture.wrap, TextureWrap::repeat);
    EXPECT_EQ(texture.filter, TextureFilter::bilinear);
    EXPECT_EQ(texture.scale, 1.0);
    EXPECT_FALSE(texture.invert);
    EXPECT_NEAR(texture.image->texels(0, 0), 1.0 / 3.0, 1e-6);
}

TEST(SceneTextures, PicturesHaveSidesOfPowersOfTwo) {
    const TemporaryFolder folder;
    write_text(folder.file("x.png"), png_bytes({.width = 3, .height = 5}, std::vector<int>(45, 100)));
    const Scene scene = parse_in(folder.path(), R"(Texture "t" "float" "imagemap" "string filename" "x.png"
        Texture "t" "spectrum" "imagemap" "string filename" "x.png")");
    EXPECT_EQ(std::get<ImageTexture<float>>(scene.float_textures.at(0)).image->texels.width(), 4);
    EXPECT_EQ(std::get<ImageTexture<RGB>>(scene.reflectance_textures.at(0)).image->texels.height(), 8);
}

TEST(SceneTextures, CheckerboardsMayHaveThreeDimensions) {
    const Scene scene = parse_world(R"(Translate 1 2 3 Scale 2 2 2
        Texture "c" "float" "checkerboard" "integer dimension" 3)");
    const auto& board = std::get<CheckerboardTexture<FloatParameter>>(scene.float_textures.at(0));
    const auto& mapping = std::get<SolidTextureMapping>(board.mapping);
    EXPECT_LT((transform_point(mapping.texture_from_world, {5, 2, 4}) - Imath::V3d(2, 0, 0.5)).length(), 1e-12);
}

TEST(SceneTextures, OnePictureIsReadOnce) {
    const TemporaryFolder folder;
    write_text(folder.file("x.png"), png_bytes({}, std::array{255, 0, 128}));
    const std::string picture = R"(" "spectrum" "imagemap" "string filename" "x.png" )";
    const Scene scene = parse_in(
        folder.path(), "Texture \"a" + picture + "Texture \"b" + picture + "\"float scale\" .5 Texture \"c" + picture +
                           "\"string encoding\" \"linear\" Texture \"d" + picture + "\"string encoding\" \"gamma 2\"");
    const auto image = [&](std::size_t i) {
        return std::get<ImageTexture<RGB>>(scene.reflectance_textures.at(i)).image;
    };
    EXPECT_EQ(image(0), image(1));
    EXPECT_NEAR(image(2)->texels(0, 0).b, 128 / 255.0, 1e-6);
    EXPECT_NEAR(image(3)->texels(0, 0).b, 128.0 * 128 / 255 / 255, 1e-6);
}

TEST(SceneTextures, ConstantScalesGoIntoPictures) {
    const TemporaryFolder folder;
    write_text(folder.file("x.png"), png_bytes({}, std::array{255, 0, 128}));
    const Scene scene = parse_in(folder.path(), R"(
        Texture "a" "spectrum" "imagemap" "string filename" "x.png" "float scale" 2
        Texture "b" "spectrum" "scale" "texture tex" "a" "float scale" .25
        Texture "c" "float" "imagemap" "string filename" "x.png"
        Texture "d" "float" "scale" "float tex" 3 "texture scale" "c")");
    EXPECT_EQ(std::get<ImageTexture<RGB>>(scene.reflectance_textures.at(0)).scale, 2.0);
    EXPECT_EQ(std::get<ImageTexture<RGB>>(scene.reflectance_textures.at(1)).scale, 0.5);
    EXPECT_EQ(std::get<ImageTexture<float>>(scene.float_textures.at(1)).scale, 3.0);
}

TEST(SceneTextures, SaysOnceThatFiltersKnowNoFootprints) {
    const TemporaryFolder folder;
    write_text(folder.file("x.png"), png_bytes({}, std::array{255, 0, 128}));
    const Scene scene = parse_in(folder.path(), R"(LightSource "infinite"
Texture "a" "spectrum" "imagemap" "string filename" "x.png" "string filter" "trilinear"
Texture "b" "float" "imagemap" "string filename" "x.png" "string filter" "EWA")");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].substr(folder.path().string().size() + 1),
              "t.pbrt:3:61: the filter \"trilinear\" is that of no level but the picture itself, here and further on: "
              "textures are not filtered over pixels but by the samples of pixels");
    EXPECT_EQ(std::get<ImageTexture<RGB>>(scene.reflectance_textures.at(0)).filter, TextureFilter::bilinear);
    EXPECT_EQ(std::get<ImageTexture<float>>(scene.float_textures.at(0)).filter, TextureFilter::gaussian);
    EXPECT_EQ(std::get<ImageTexture<float>>(scene.float_textures.at(0)).image->texels(0, 0), 1.0f) << "red, as in pbrt";
}

TEST(SceneTextures, SaysThatOnlyPngHasAnEncoding) {
    const TemporaryFolder folder;
    write_text(folder.file("x.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x50\x50\x50\x50");
    const Scene scene = parse_in(folder.path(), R"(LightSource "infinite"
Texture "a" "spectrum" "imagemap" "string filename" "x.hdr" "string encoding" "sRGB")");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].substr(folder.path().string().size() + 1),
              "t.pbrt:3:61: the encoding \"sRGB\" is that of PNG pictures only, as in pbrt-v4: the file's numbers are "
              "linear");
}

// --- Errors

struct BadTexture {
    std::string text, message;
};

TEST(SceneTextures, RefusesWhatIsNoTexture) {
    const BadTexture bad[] = {
        {R"(Texture "x" "color" "constant")",
         "13: found unknown kind of texture \"color\", expected a known one (nearest known name: \"float\")"},
        {R"(Texture "x" "spectrum" "constnat")",
         "24: found unknown spectrum texture \"constnat\", expected a known one (nearest known name: \"constant\")"},
        {R"(Texture "x" "spectrum" "marble")",
         "24: found spectrum texture \"marble\", expected a supported one (known to pbrt-v4 and not yet supported "
         "here; "
         "supported: constant, scale, mix, imagemap, checkerboard)"},
        {R"(Texture "x" "float" "windy")",
         "21: found float texture \"windy\", expected a supported one (known to pbrt-v4 and not yet supported here; "
         "supported: constant, scale, mix, imagemap, checkerboard)"},
        {R"(Texture "x" "float" "checkerboard" "integer dimension" 4)",
         "56: found a checkerboard in 4 dimensions, expected 2 or 3"},
        {R"(Texture "x" "float" "checkerboard" "string mapping" "planer")",
         "53: found unknown mapping \"planer\", expected a known one (nearest known name: \"planar\")"},
        {R"(Texture "x" "float" "mix" "rgb tex1" [0 0 0])",
         "27: found type \"rgb\" of parameter \"tex1\" of float texture \"mix\", expected float or texture"},
        {R"(Texture "x" "spectrum" "mix" "float tex1" .5)",
         "30: found type \"float\" of parameter \"tex1\" of spectrum texture \"mix\", expected rgb, blackbody, "
         "spectrum "
         "or texture"},
        {R"(Texture "x" "spectrum" "constant" "rgb value" [0 2 0])", "50: found 2, expected reflectances from 0 to 1"},
        {R"(Texture "x" "spectrum" "constant" "texture value" "y")",
         "35: found type \"texture\" of parameter \"value\" of spectrum texture \"constant\", expected a supported one "
         "(known to pbrt-v4 and not yet supported here; supported: rgb, blackbody or spectrum)"},
        {R"(Texture "x" "float" "mix" "texture tex1" ["a" "b"])",
         "27: found 2 values for parameter \"tex1\" of float texture \"mix\", expected 1"},
        {R"(Texture "x" "float" "imagemap")",
         "21: found an imagemap without a file, expected a parameter \"string filename\""},
        {R"(Texture "x" "spectrum")", "23: found the end of the file, expected a string after Texture"},
        {R"(Texture "x" "float" "constant" Texture "x" "float" "constant")",
         "40: found a second float texture \"x\", expected each name only once (the first is at t.pbrt:2:9)"},
    };
    for (const BadTexture& texture : bad) {
        EXPECT_EQ(world_error_of(texture.text), "t.pbrt:2:" + texture.message) << texture.text;
    }
}

TEST(SceneTextures, RefusesNamesThatStandForNoTexture) {
    const std::string textures =
        R"(Texture "bricks" "spectrum" "checkerboard" Texture "bumps" "float" "checkerboard" )";
    const auto error_of = [&](const std::string& text) {
        const std::string message = world_error_of(textures + "\n" + text);
        return message.substr(message.find(' ') + 1);
    };
    EXPECT_EQ(
        error_of(R"(Material "diffuse" "texture reflectance" "brick")"),
        "found unknown spectrum texture \"brick\", expected one that a Texture directive before it makes (nearest "
        "known name: \"bricks\")");
    EXPECT_EQ(error_of(R"(Material "diffuse" "texture reflectance" "bumps")"),
              "found the float texture \"bumps\", expected a spectrum texture");
    EXPECT_EQ(error_of(R"(Texture "x" "float" "scale" "texture tex" "bricks")"),
              "found the spectrum texture \"bricks\", expected a float texture");
    // Itself.
    EXPECT_EQ(error_of(R"(Texture "x" "float" "scale" "texture tex" "x")"),
              "found unknown float texture \"x\", expected one that a Texture directive before it makes (bumps)");
    EXPECT_EQ(
        world_error_of(R"(Material "diffuse" "texture reflectance" "t")"),
        "t.pbrt:2:42: found unknown spectrum texture \"t\", expected one that a Texture directive before it makes "
        "(none is known)");
}

TEST(SceneTextures, RefusesPicturesThatCantBeRead) {
    const TemporaryFolder folder;
    write_text(folder.file("empty.png"), "");
    write_text(folder.file("x.png"), png_bytes({}, std::array{255, 0, 128}));
    const auto error = [&](const std::string& parameters) {
        return error_in(folder.path(), R"(Texture "t" "spectrum" "imagemap" )" + parameters);
    };
    EXPECT_EQ(error(R"("string filename" "no.png")"),
              "t.pbrt:2:53: found picture \"no.png\" (No such file or directory), expected one that can be read");
    EXPECT_EQ(error(R"("string filename" "empty.png")"),
              "t.pbrt:2:53: found picture \"empty.png\" (byte 0: found another signature, expected that of a PNG "
              "picture), expected one that can be read");
    EXPECT_EQ(error(R"("string filename" "x.tif")"),
              "t.pbrt:2:53: found picture \"x.tif\" (a name that ends in none of .png .jpg .jpeg .hdr .pfm .exr), "
              "expected one that can be read");
    EXPECT_EQ(
        error(R"("string filename" "x.png" "string encoding" "gamma")"),
        "t.pbrt:2:79: found the encoding \"gamma\", expected sRGB, linear, or gamma and an exponent from 0.1 to 5");
    EXPECT_EQ(
        error(R"("string filename" "x.png" "string encoding" "gamma 0")"),
        "t.pbrt:2:79: found the encoding \"gamma 0\", expected sRGB, linear, or gamma and an exponent from 0.1 to "
        "5");
    EXPECT_EQ(error(R"("string filename" "x.png" "string wrap" "mirror")"),
              "t.pbrt:2:75: found unknown wrap \"mirror\", expected a known one (repeat, black, clamp, "
              "octahedralsphere)");
}

TEST(SceneTextures, EvaluationsStayWithinBounds) {
    // Each is a mix of the one before with itself: the n-th comes to 2^n - 1.
    std::string world = R"(Texture "t1" "float" "checkerboard" )";
    const auto doubled = [](int i) {
        const std::string before = "\"t" + std::to_string(i - 1) + "\" ";
        return "\nTexture \"t" + std::to_string(i) + "\" \"float\" \"mix\" \"texture tex1\" " + before +
               "\"texture tex2\" " + before;
    };
    for (int i = 2; i <= 8; ++i) world += doubled(i);
    EXPECT_EQ(parse_world(world).float_textures.size(), 8u);
    EXPECT_EQ(world_error_of(world + doubled(9)),
              "t.pbrt:10:22: found a texture of 511 evaluations of textures, expected at most 256");
}

}  // namespace
}  // namespace emulsion
