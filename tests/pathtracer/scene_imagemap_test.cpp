#include "pathtracer/scene_imagemap.h"

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "scene_text.h"
#include "support/png_bytes.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::png_bytes;

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

TEST(SceneImagemap, PicturesAreFoundBesideTheScene) {
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

TEST(SceneImagemap, PicturesHaveTheDefaultsOfPbrt) {
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

TEST(SceneImagemap, PicturesHaveSidesOfPowersOfTwo) {
    const TemporaryFolder folder;
    write_text(folder.file("x.png"), png_bytes({.width = 3, .height = 5}, std::vector<int>(45, 100)));
    const Scene scene = parse_in(folder.path(), R"(Texture "t" "float" "imagemap" "string filename" "x.png"
        Texture "t" "spectrum" "imagemap" "string filename" "x.png")");
    EXPECT_EQ(std::get<ImageTexture<float>>(scene.float_textures.at(0)).image->texels.width(), 4);
    EXPECT_EQ(std::get<ImageTexture<RGB>>(scene.reflectance_textures.at(0)).image->texels.height(), 8);
}

TEST(SceneImagemap, OnePictureIsReadOnce) {
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

TEST(SceneImagemap, ConstantScalesGoIntoPictures) {
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

TEST(SceneImagemap, SaysOnceThatFiltersKnowNoFootprints) {
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

TEST(SceneImagemap, SaysThatOnlyPngHasAnEncoding) {
    const TemporaryFolder folder;
    write_text(folder.file("x.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x50\x50\x50\x50");
    const Scene scene = parse_in(folder.path(), R"(LightSource "infinite"
Texture "a" "spectrum" "imagemap" "string filename" "x.hdr" "string encoding" "sRGB")");
    ASSERT_EQ(scene.warnings.size(), 1u);
    EXPECT_EQ(scene.warnings[0].substr(folder.path().string().size() + 1),
              "t.pbrt:3:61: the encoding \"sRGB\" is that of PNG pictures only, as in pbrt-v4: the file's numbers are "
              "linear");
}

TEST(SceneImagemap, RefusesPicturesThatCantBeRead) {
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

}  // namespace
}  // namespace emulsion
