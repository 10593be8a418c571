#include "pathtracer/texture_image.h"

#include <array>
#include <span>
#include <string>

#include <gtest/gtest.h>

#include "support/png_bytes.h"
#include "texture_image_fixture.h"

namespace emulsion {
namespace {

using testing::png_bytes;
using testing::PngFormat;

TEST(TextureImage, PngOfEightBitsIsSrgb) {
    const Image<RGB> image = read_rgb_texels("x.png", png_bytes({.width = 2, .height = 2}, kFourColours)).texels;
    ASSERT_EQ(image.width(), 2);
    ASSERT_EQ(image.height(), 2);
    expect_rgb(image(0, 0), 0.0, srgb_decoded(128 / 255.0), 1.0);
    expect_rgb(image(1, 0), srgb_decoded(10 / 255.0), srgb_decoded(20 / 255.0), srgb_decoded(30 / 255.0));
    expect_rgb(image(0, 1), 1.0, 1.0, 1.0);
    expect_rgb(image(1, 1), 1 / 255.0 / 12.92, 2 / 255.0 / 12.92, 3 / 255.0 / 12.92);
}

TEST(TextureImage, PngIsDecodedAsAskedFor) {
    const std::string bytes = png_bytes({.width = 2, .height = 2}, kFourColours);
    expect_rgb(read_rgb_texels("x.png", bytes, LinearTransfer{}).texels(1, 0), 10 / 255.0, 20 / 255.0, 30 / 255.0);
    expect_rgb(read_rgb_texels("x.png", bytes, GammaTransfer{2.0}).texels(0, 0), 0.0, 128.0 * 128 / 255 / 255, 1.0);
}

TEST(TextureImage, PngOfSixteenBitsKeepsThem) {
    const std::array codes = {0, 257, 65535};
    const std::string bytes = png_bytes({.bits = 16}, codes);
    expect_rgb(read_rgb_texels("x.png", bytes, LinearTransfer{}).texels(0, 0), 0.0, 257 / 65535.0, 1.0);
    expect_rgb(read_rgb_texels("X.PNG", bytes).texels(0, 0), 0.0, 257 / 65535.0 / 12.92, 1.0);
}

TEST(TextureImage, PngOfGreyAndOfAPalette) {
    const std::array grey = {51, 102};
    const Image<RGB> image =
        read_rgb_texels("x.png", png_bytes({.width = 2, .colour_type = 0}, grey), LinearTransfer{}).texels;
    expect_rgb(image(1, 0), 0.4, 0.4, 0.4);

    const std::array grey_alpha = {51, 0};
    expect_rgb(read_rgb_texels("x.png", png_bytes({.colour_type = 4}, grey_alpha), LinearTransfer{}).texels(0, 0), 0.2,
               0.2, 0.2);
    const std::array index = {1};
    const std::string palette = std::string("\0\0\0", 3) + "\x33\x66\x99";
    expect_rgb(read_rgb_texels("x.png", png_bytes({.colour_type = 3, .palette = palette}, index), LinearTransfer{})
                   .texels(0, 0),
               0.2, 0.4, 0.6);
}

TEST(TextureImage, NumbersAreTheMeanOrAlphaAsInPbrt) {
    const LinearTransfer linear;
    const auto number = [&](const PngFormat& format, std::span<const int> codes, TextureFilter filter) {
        return read_number_texels("x.png", png_bytes(format, codes), linear, filter)(0, 0);
    };
    const std::array rgb = {51, 102, 153};
    EXPECT_NEAR(number({}, rgb, TextureFilter::bilinear), 0.4, 1e-6);
    EXPECT_NEAR(number({}, rgb, TextureFilter::nearest), 0.2, 1e-6);
    const std::array with_alpha = {51, 102, 153, 204};
    EXPECT_NEAR(number({.colour_type = 6}, with_alpha, TextureFilter::bilinear), 0.8, 1e-6);
    EXPECT_NEAR(number({.colour_type = 6}, with_alpha, TextureFilter::nearest), 0.2, 1e-6);
    const std::array opaque = {51, 102, 153, 255};
    EXPECT_NEAR(number({.colour_type = 6}, opaque, TextureFilter::bilinear), 0.4, 1e-6);
    const std::array grey = {51};
    EXPECT_NEAR(number({.colour_type = 0}, grey, TextureFilter::bilinear), 0.2, 1e-6);
    EXPECT_NEAR(read_number_texels("x.png", png_bytes({.colour_type = 6}, with_alpha), SrgbTransfer{},
                                   TextureFilter::bilinear)(0, 0),
                srgb_decoded(0.8), 1e-6);
}

TEST(TextureImage, JpegIsSrgbWhateverIsAskedFor) {
    const Image<RGB> grey = read_rgb_texels("x.jpg", grey_jpeg(), LinearTransfer{}).texels;
    ASSERT_EQ(grey.width(), 8);
    ASSERT_EQ(grey.height(), 8);
    const double expected = srgb_decoded(200 / 255.0);
    expect_rgb(grey(3, 5), expected, expected, expected);

    // ITU-T T.871: R = Y + 1.402 Cr, G = Y - 0.714136 Cr, B = Y.
    const Image<RGB> colour = read_rgb_texels("x.JPEG", colour_jpeg()).texels;
    expect_rgb(colour(0, 7), srgb_decoded(218 / 255.0), srgb_decoded(82 / 255.0), srgb_decoded(128 / 255.0), 0.01);
}

TEST(TextureImage, TheNameTellsTheFormat) {
    EXPECT_EQ(error_of("x.tga", ""), "x.tga: a name that ends in none of .png .jpg .jpeg .hdr .pfm .exr");
    EXPECT_EQ(error_of("png", ""), "png: a name that ends in none of .png .jpg .jpeg .hdr .pfm .exr");
    EXPECT_EQ(error_of("x.png", grey_jpeg()), "x.png: byte 0: found another signature, expected that of a PNG picture");
    EXPECT_EQ(error_of("x.jpg", png_bytes({}, std::array{1, 2, 3})),
              "x.jpg: byte 0: found another signature, expected that of a JPEG picture");
}

}  // namespace
}  // namespace emulsion
