#include "pathtracer/prepared_textures.h"

#include <array>
#include <memory>

#include <gtest/gtest.h>

#include "analytic_scenes.h"
#include "pathtracer/model_channels.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {
namespace {

using testing::slope;

using Spectral = SpectralTransport<4>;
const SpectrumTableIndex<4> kIndex{testing::kTestWavelengths_nm};

TexturePoint at_uv(float u, float v) { return {{0, 0, 0}, {u, v}}; }

template <class Texel>
std::shared_ptr<const TextureImage<Texel>> image_of(int width, int height, const std::vector<Texel>& texels) {
    TextureImage<Texel> image{"x.png", Image<Texel>(width, height)};
    std::copy(texels.begin(), texels.end(), image.texels.pixels().begin());
    return std::make_shared<const TextureImage<Texel>>(std::move(image));
}

/// The value of the last of these textures of numbers.
float number(const std::vector<FloatTexture>& textures, const TexturePoint& point) {
    SpectrumTables spectra;
    const PreparedTextures prepared(textures, {}, spectra);
    return prepared.number({static_cast<int>(textures.size()) - 1}, point);
}

/// The same of reflectances.
template <class Transport = Spectral>
SampledSpectrum<Transport::kChannels> reflectance(const std::vector<ReflectanceTexture>& textures,
                                                  const TexturePoint& point, const typename Transport::Index& index,
                                                  const std::vector<FloatTexture>& numbers = {}) {
    SpectrumTables spectra;
    PreparedTextures prepared(numbers, textures, spectra);
    const FixedChannels srgb = rgb_channels("sRGB");
    spectra.prepare(srgb);
    prepared.prepare(srgb);
    return prepared.reflectance({static_cast<int>(textures.size()) - 1}, point, index);
}
SampledSpectrum<4> reflectance(const std::vector<ReflectanceTexture>& textures, const TexturePoint& point,
                               const std::vector<FloatTexture>& numbers = {}) {
    return reflectance<Spectral>(textures, point, kIndex, numbers);
}

void expect_near(const SampledSpectrum<4>& found, const Spectrum& expected, double tolerance = 1e-6) {
    for (int i = 0; i < 4; ++i) {
        const auto lambda_nm = static_cast<double>(testing::kTestWavelengths_nm[static_cast<std::size_t>(i)]);
        EXPECT_NEAR(found[i], eval(expected, lambda_nm), tolerance) << lambda_nm;
    }
}

TEST(PreparedTextures, CheckerboardsAlternateByWholeParts) {
    const CheckerboardTexture<FloatParameter> board{3.0, 5.0, UvMapping{}};
    const auto value = [&](float u, float v) { return number({board}, at_uv(u, v)); };
    EXPECT_EQ(value(0.5f, 0.5f), 3.0f);
    EXPECT_EQ(value(1.5f, 0.5f), 5.0f);
    EXPECT_EQ(value(0.5f, 1.5f), 5.0f);
    EXPECT_EQ(value(1.5f, 1.5f), 3.0f);
    EXPECT_EQ(value(-0.5f, 0.5f), 5.0f);
    EXPECT_EQ(value(-0.5f, -0.5f), 3.0f);
    EXPECT_EQ(value(-1.5f, 0.5f), 3.0f);
    EXPECT_EQ(value(-3.5f, -2.5f), 5.0f);
    EXPECT_EQ(value(1e30f, 1e30f), 3.0f);  // whatever the field, a number of the board
}

TEST(PreparedTextures, CheckerboardsInSpaceAlternateAlongThreeAxes) {
    // Twice as large as the world's, moved by one.
    const Imath::M44d texture_from_world = translation({-1, 0, 0}) * scaling({0.5, 0.5, 0.5});
    const CheckerboardTexture<FloatParameter> board{3.0, 5.0, SolidTextureMapping{texture_from_world}};
    const auto value = [&](float x, float y, float z) { return number({board}, {{x, y, z}, {0.5f, 0.5f}}); };
    EXPECT_EQ(value(2, 1, 1), 3.0f);
    EXPECT_EQ(value(4, 1, 1), 5.0f);
    EXPECT_EQ(value(2, 3, 1), 5.0f);
    EXPECT_EQ(value(2, 1, 3), 5.0f);
    EXPECT_EQ(value(4, 3, 1), 3.0f);
    EXPECT_EQ(value(4, 3, 3), 5.0f);
    EXPECT_EQ(value(0, 1, 1), 5.0f);
}

TEST(PreparedTextures, NumbersAreScaledAndMixed) {
    const CheckerboardTexture<FloatParameter> board{0.25, 0.75, UvMapping{}};
    const TextureIndex first{0};
    const TexturePoint here = at_uv(0.5f, 0.5f), next = at_uv(1.5f, 0.5f);
    EXPECT_FLOAT_EQ(number({board, ScaleTexture<FloatParameter>{first, 3.0}}, here), 0.75f);
    EXPECT_FLOAT_EQ(number({board, ScaleTexture<FloatParameter>{first, first}}, next), 0.5625f);
    EXPECT_FLOAT_EQ(number({board, MixTexture<FloatParameter>{2.0, 4.0, first}}, here), 2.5f);
    EXPECT_FLOAT_EQ(number({board, MixTexture<FloatParameter>{2.0, 4.0, first}}, next), 3.5f);
    EXPECT_FLOAT_EQ(number({board, MixTexture<FloatParameter>{first, 0.0, 0.5}}, next), 0.375f);
}

TEST(PreparedTextures, NumbersOfImages) {
    ImageTexture<float> texture{image_of<float>(2, 1, {0.25f, 0.5f}), UvMapping{}};
    texture.filter = TextureFilter::nearest;
    EXPECT_FLOAT_EQ(number({texture}, at_uv(0.75f, 0.5f)), 0.5f);
    texture.scale = 3.0;
    EXPECT_FLOAT_EQ(number({texture}, at_uv(0.75f, 0.5f)), 1.5f);
    texture.invert = true;
    EXPECT_FLOAT_EQ(number({texture}, at_uv(0.25f, 0.5f)), 0.25f);
    EXPECT_FLOAT_EQ(number({texture}, at_uv(0.75f, 0.5f)), 0.0f);   // not -0.5
    EXPECT_FLOAT_EQ(number({texture}, at_uv(1.25f, 0.5f)), 0.25f);  // repeats
    texture.mapping = UvMapping{0.5, 1.0, 0.5, 0.0};
    EXPECT_FLOAT_EQ(number({texture}, at_uv(0.25f, 0.5f)), 0.0f);
}

TEST(PreparedTextures, ConstantReflectancesAreExact) {
    const Spectrum first = slope(0.1, 0.4), second = slope(0.9, 0.3);
    const CheckerboardTexture<ReflectanceParameter> board{first, second, UvMapping{2.0, 1.0}};
    expect_near(reflectance({board}, at_uv(0.25f, 0.5f)), first);
    expect_near(reflectance({board}, at_uv(0.75f, 0.5f)), second);

    const TextureIndex below{0};
    const MixTexture<ReflectanceParameter> mix{below, Spectrum(ConstantSpectrum{0.5}), 0.25};
    expect_near(reflectance({board, mix}, at_uv(0.25f, 0.5f)), slope(0.75 * 0.1 + 0.125, 0.75 * 0.4 + 0.125));
    const ScaleTexture<ReflectanceParameter> scale{below, 0.5};
    expect_near(reflectance({board, scale}, at_uv(0.75f, 0.5f)), slope(0.45, 0.15));
}

TEST(PreparedTextures, TexturesOfNumbersScaleReflectances) {
    const CheckerboardTexture<FloatParameter> board{0.5, 0.25, UvMapping{}};
    const ScaleTexture<ReflectanceParameter> scale{Spectrum(slope(0.2, 0.8)), TextureIndex{0}};
    expect_near(reflectance({scale}, at_uv(0.5f, 0.5f), {board}), slope(0.1, 0.4));
    expect_near(reflectance({scale}, at_uv(1.5f, 0.5f), {board}), slope(0.05, 0.2));
    const MixTexture<ReflectanceParameter> mix{Spectrum(ConstantSpectrum{0.0}), Spectrum(slope(0.2, 0.8)),
                                               TextureIndex{0}};
    expect_near(reflectance({mix}, at_uv(0.5f, 0.5f), {board}), slope(0.1, 0.4));
}

TEST(PreparedTextures, ReflectancesStayInTheirRange) {
    const ScaleTexture<ReflectanceParameter> bright{Spectrum(ConstantSpectrum{0.5}), 3.0};
    expect_near(reflectance({bright}, at_uv(0, 0)), ConstantSpectrum{1.0});
    const ScaleTexture<ReflectanceParameter> negative{Spectrum(ConstantSpectrum{0.5}), -3.0};
    expect_near(reflectance({negative}, at_uv(0, 0)), ConstantSpectrum{0.0});
    // Only at the end: what lies between may be anything.
    const ScaleTexture<ReflectanceParameter> back{TextureIndex{0}, 0.2};
    expect_near(reflectance({bright, back}, at_uv(0, 0)), ConstantSpectrum{0.3});
}

TEST(PreparedTextures, TexelsBecomeSpectraOfTheirColour) {
    const RGB rgb{0.8f, 0.3f, 0.1f};
    const ImageTexture<RGB> texture{image_of<RGB>(1, 1, {rgb}), UvMapping{}};
    const SigmoidTable table(rgb_space("sRGB"));
    expect_near(reflectance({texture}, at_uv(0.3f, 0.3f)), sigmoid_of(table.reflectance(rgb)), 2e-5);

    ImageTexture<RGB> inverted = texture;
    inverted.scale = 0.5;
    inverted.invert = true;
    expect_near(reflectance({inverted}, at_uv(0, 0)), sigmoid_of(table.reflectance({0.6f, 0.85f, 0.95f})), 2e-5);

    const ImageTexture<RGB> white{image_of<RGB>(1, 1, {{1, 1, 1}}), UvMapping{}};
    expect_near(reflectance({white}, at_uv(0, 0)), ConstantSpectrum{1.0});
    const ImageTexture<RGB> too_bright{image_of<RGB>(1, 1, {{7, 7, 7}}), UvMapping{}};
    expect_near(reflectance({too_bright}, at_uv(0, 0)), ConstantSpectrum{1.0});
}

TEST(PreparedTextures, TexelsAreColoursOfTheirSpace) {
    const RGB rgb{0.8f, 0.3f, 0.4f};
    for (const ColorSpace space : {ColorSpace::rec2020, ColorSpace::dci_p3, ColorSpace::aces2065_1}) {
        const auto in_space = [&](const RGB& texel) {
            TextureImage<RGB> image{"x.exr", Image<RGB>(1, 1), space};
            image.texels(0, 0) = texel;
            return ImageTexture<RGB>{std::make_shared<const TextureImage<RGB>>(std::move(image)), UvMapping{}};
        };
        const SigmoidTable table(rgb_space_of(space));
        expect_near(reflectance({in_space(rgb)}, at_uv(0, 0)), sigmoid_of(table.reflectance(rgb)), 2e-5);
        // Beside one of sRGB, each keeps its own.
        const ImageTexture<RGB> srgb{image_of<RGB>(1, 1, {rgb}), UvMapping{}};
        expect_near(reflectance({srgb, in_space(rgb)}, at_uv(0, 0)), sigmoid_of(table.reflectance(rgb)), 2e-5);

        const auto white = reflectance<FixedTransport<3>>({in_space({1, 1, 1})}, at_uv(0, 0), {});
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(white[i], 1.0f, 1e-6f);
        const auto colour = reflectance<FixedTransport<3>>({in_space({0.5f, 0.25f, 0.25f})}, at_uv(0, 0), {});
        EXPECT_GT(colour[0], 0.52f) << "its red is beyond that of sRGB";
        EXPECT_LT(colour[1], 0.25f);
    }
}

TEST(PreparedTextures, TexelsAreMixedAsColours) {
    ImageTexture<RGB> texture{image_of<RGB>(2, 1, {{0.2f, 0.4f, 0.6f}, {0.6f, 0.4f, 0.2f}}), UvMapping{}};
    const SigmoidTable table(rgb_space("sRGB"));
    expect_near(reflectance({texture}, at_uv(0.375f, 0.5f)), sigmoid_of(table.reflectance({0.3f, 0.4f, 0.5f})), 2e-5);
}

TEST(PreparedTextures, ColourTransportTakesColours) {
    const ImageTexture<RGB> texture{image_of<RGB>(1, 1, {{0.8f, 0.3f, 1.5f}}), UvMapping{}};
    const auto rgb = reflectance<FixedTransport<3>>({texture}, at_uv(0, 0), {});
    EXPECT_FLOAT_EQ(rgb[0], 0.8f);
    EXPECT_FLOAT_EQ(rgb[1], 0.3f);
    EXPECT_FLOAT_EQ(rgb[2], 1.0f);
}

/// A floor of two kinds of tiles under an even sky: what is seen is the tile that lies there.
TEST(PreparedTextures, SurfacesShowThem) {
    Scene scene;
    scene.reflectance_textures.emplace_back(CheckerboardTexture<ReflectanceParameter>{
        Spectrum(slope(0.2, 0.6)), Spectrum(slope(0.7, 0.1)), UvMapping{2, 2}});
    scene.materials = {DiffuseMaterial{TextureIndex{0}}};
    TriangleMesh floor = testing::parallelogram({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    floor.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    Shape shape;
    shape.geometry = floor;
    scene.shapes.push_back(shape);
    scene.lights = {UniformInfiniteLight{{ConstantSpectrum{2.0}, 1.0}}};
    scene.integrator.max_depth = 3;

    const auto expect_seen = [&](float x, float y, const PiecewiseLinearSpectrum& tile) {
        const auto seen = testing::estimate_radiance(scene, {{x, y, 2}, {0, 0, -1}}, 1024);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto lambda_nm = static_cast<double>(testing::kTestWavelengths_nm[i]);
            EXPECT_NEAR(seen.mean[i], 2.0 * eval(Spectrum(tile), lambda_nm), 5.0 * seen.standard_error[i] + 1e-5);
        }
    };
    expect_seen(0.25f, 0.3f, slope(0.2, 0.6));
    expect_seen(0.75f, 0.3f, slope(0.7, 0.1));
    expect_seen(0.25f, 0.7f, slope(0.7, 0.1));
    expect_seen(0.75f, 0.7f, slope(0.2, 0.6));
}

}  // namespace
}  // namespace emulsion
