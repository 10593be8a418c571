// Pictures of the scene itself as textures: PFM, Radiance and EXR.

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "film/radiance_file.h"
#include "pathtracer/texture_image.h"
#include "spectrum/rgb_space.h"
#include "support/temporary_folder.h"
#include "texture_image_fixture.h"

namespace emulsion {
namespace {

TEST(TextureSceneReferred, ScenePicturesGiveTheirNumbers) {
    const TemporaryFolder folder;
    Image<XYZ> xyz(2, 1);
    // 0.5, 0.25, 2 of linear sRGB.
    const auto p = xyz_from_rgb(rgb_space("sRGB")) * std::array{0.5, 0.25, 2.0};
    xyz(1, 0) = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};

    const std::filesystem::path pfm = folder.file("x.pfm"), hdr = folder.file("x.hdr"), exr = folder.file("x.exr");
    write_pfm(pfm, xyz);
    expect_rgb(read_rgb_texels(pfm, read_text(pfm)).texels(1, 0), 0.5, 0.25, 2.0, 1e-5);

    write_radiance(hdr, xyz);
    expect_rgb(read_rgb_texels(hdr, read_text(hdr)).texels(1, 0), 0.5, 0.25, 2.0, 2.0 / 255);
    EXPECT_NEAR(read_number_texels(hdr, read_text(hdr), {}, TextureFilter::bilinear)(1, 0), 2.75 / 3, 2.0 / 255);

    for (const std::string space : {"sRGB", "XYZ"}) {
        ExrOptions options;
        options.space = space;
        options.white_luminance_cdm2 = 40.0;  // has no effect, as in pbrt-v4: the numbers count
        write_exr(exr, xyz, {}, options);
        expect_rgb(read_rgb_texels(exr, read_text(exr)).texels(1, 0), 0.5, 0.25, 2.0, 1e-5);
    }
}

TEST(TextureSceneReferred, ExrNumbersAreThoseOfTheirSpace) {
    struct Known {
        std::string name;
        ColorSpace space;
    };
    const TemporaryFolder folder;
    const std::filesystem::path exr = folder.file("x.exr");
    for (const Known& known :
         {Known{"sRGB", ColorSpace::srgb}, Known{"Rec2020", ColorSpace::rec2020},
          Known{"Display_P3", ColorSpace::dci_p3}, Known{"ACES2065_1_AP0", ColorSpace::aces2065_1}}) {
        Image<XYZ> xyz(2, 1);
        const auto p = xyz_from_rgb(rgb_space(known.name)) * std::array{0.5, 0.25, 2.0};
        xyz(1, 0) = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
        write_exr(exr, xyz, {}, {.space = known.name});
        const RgbTexels read = read_rgb_texels(exr, read_text(exr));
        EXPECT_EQ(read.space, known.space) << known.name;
        EXPECT_EQ(read.note, "") << known.name;
        expect_rgb(read.texels(1, 0), 0.5, 0.25, 2.0, 1e-5);
        // A number has no space.
        EXPECT_NEAR(read_number_texels(exr, read_text(exr), {}, TextureFilter::bilinear)(1, 0), 2.75 / 3, 1e-5);
    }
    // Chromaticities of none of the four: sRGB, and said.
    Image<XYZ> xyz(1, 1);
    const auto p = xyz_from_rgb(rgb_space("Adobe_RGB_1998")) * std::array{0.5, 0.25, 2.0};
    xyz(0, 0) = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
    write_exr(exr, xyz, {}, {.space = "Adobe_RGB_1998"});
    const RgbTexels read = read_rgb_texels(exr, read_text(exr));
    EXPECT_EQ(read.space, ColorSpace::srgb);
    EXPECT_EQ(read.note, "its chromaticities are those of no space that is known: taken as sRGB, as in pbrt-v4");
    expect_rgb(read.texels(0, 0), 0.5, 0.25, 2.0, 1e-5);
}

/// Channels of floats, by name, of one row.
void write_channels(const std::filesystem::path& path, const std::map<std::string, std::vector<float>>& channels) {
    const int width = static_cast<int>(channels.begin()->second.size());
    Imf::Header header(width, 1);
    Imf::FrameBuffer places;
    for (const auto& [name, values] : channels) {
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        places.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(places);
    file.writePixels(1);
}

TEST(TextureSceneReferred, AnExrOfOneChannelIsGrey) {
    const TemporaryFolder folder;
    const std::filesystem::path exr = folder.file("x.exr");
    for (const std::string name : {"Y", "Z", "height"}) {
        write_channels(exr, {{name, {0.25f, 3.0f}}});
        expect_rgb(read_rgb_texels(exr, read_text(exr)).texels(1, 0), 3.0, 3.0, 3.0);
        EXPECT_EQ(read_number_texels(exr, read_text(exr), {}, TextureFilter::bilinear)(0, 0), 0.25f);
    }
    write_channels(exr, {{"Y", {1.0f}}, {"RY", {1.0f}}});
    EXPECT_EQ(error_of(exr.string(), read_text(exr)),
              exr.string() + ": has the channels RY Y, expected X Y Z or R G B");
}

TEST(TextureSceneReferred, TheAlphaOfAnExrIsItsNumber) {
    const TemporaryFolder folder;
    const std::filesystem::path exr = folder.file("x.exr");
    const std::vector<float> red = {1, 2}, green = {3, 4}, blue = {5, 6};
    write_channels(exr, {{"R", red}, {"G", green}, {"B", blue}, {"A", {0.5f, 1.0f}}});
    EXPECT_EQ(read_number_texels(exr, read_text(exr), {}, TextureFilter::bilinear)(0, 0), 0.5f);
    EXPECT_EQ(read_number_texels(exr, read_text(exr), {}, TextureFilter::nearest)(1, 0), 2.0f);
    expect_rgb(read_rgb_texels(exr, read_text(exr)).texels(1, 0), 2.0, 4.0, 6.0);
    write_channels(exr, {{"R", red}, {"G", green}, {"B", blue}, {"A", {1.0f, 1.0f}}});
    EXPECT_EQ(read_number_texels(exr, read_text(exr), {}, TextureFilter::bilinear)(0, 0), 3.0f);
}

TEST(TextureSceneReferred, RadianceNumbersAreThoseOfTheFile) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.file("x.hdr");
    // (128, 64, 32) * 2^-8, whatever the exposure was.
    write_text(path, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=4\nCOLORCORR=1 2 1\n\n-Y 1 +X 1\n" +
                         bytes_of({128, 64, 32, 128}));
    expect_rgb(read_rgb_texels(path, read_text(path)).texels(0, 0), 0.5, 0.25, 0.125, 0.002);
}

TEST(TextureSceneReferred, TexelsMustBeFinite) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.file("x.pfm");
    Image<XYZ> xyz(2, 1);
    xyz(1, 0).y = INFINITY;
    write_pfm(path, xyz);
    const std::string message = error_of(path.string(), read_text(path));
    EXPECT_EQ(message.substr(0, message.find("found")), path.string() + ": texel (1, 0): ");
}

}  // namespace
}  // namespace emulsion
