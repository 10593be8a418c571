#include "pathtracer/scene_textures.h"

#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "pathtracer/scene_transform.h"
#include "scene_text.h"

namespace emulsion {
namespace {

using testing::parse_world;

double constant_of(const ReflectanceParameter& parameter) {
    return std::get<ConstantSpectrum>(std::get<Spectrum>(parameter)).value;
}

const ReflectanceParameter& last_reflectance(const Scene& scene) {
    return std::get<DiffuseMaterial>(scene.materials.back()).reflectance;
}

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

TEST(SceneTextures, CheckerboardsMayHaveThreeDimensions) {
    const Scene scene = parse_world(R"(Translate 1 2 3 Scale 2 2 2
        Texture "c" "float" "checkerboard" "integer dimension" 3)");
    const auto& board = std::get<CheckerboardTexture<FloatParameter>>(scene.float_textures.at(0));
    const auto& mapping = std::get<SolidTextureMapping>(board.mapping);
    EXPECT_LT((transform_point(mapping.texture_from_world, {5, 2, 4}) - Imath::V3d(2, 0, 0.5)).length(), 1e-12);
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

}  // namespace
}  // namespace emulsion
