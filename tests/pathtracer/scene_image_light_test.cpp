#include "pathtracer/scene_image_light.h"

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "pathtracer/scene_transform.h"
#include "scene_lights_fixture.h"
#include "spectrum/named_spectra.h"
#include "spectrum/reflectance_weights.h"
#include "support/png_bytes.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::png_bytes;

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

}  // namespace
}  // namespace emulsion
