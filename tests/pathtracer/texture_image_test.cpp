#include "pathtracer/texture_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "film/radiance_file.h"
#include "pathtracer/image_decoder.h"
#include "spectrum/rgb_space.h"
#include "support/png_bytes.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::png_bytes;
using testing::PngFormat;

/// IEC 61966-2-1.
double srgb_decoded(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

void expect_rgb(const RGB& found, double r, double g, double b, double tolerance = 1e-6) {
    EXPECT_NEAR(found.r, r, tolerance);
    EXPECT_NEAR(found.g, g, tolerance);
    EXPECT_NEAR(found.b, b, tolerance);
}

/// The message of reading these bytes, or "(no error)".
std::string error_of(const std::string& name, const std::string& bytes) {
    try {
        static_cast<void>(read_rgb_texels(name, bytes));
    } catch (const IoError& error) {
        return error.what();
    }
    return "(no error)";
}

// --- PNG

constexpr std::array kFourColours = {0, 128, 255, 10, 20, 30, 255, 255, 255, 1, 2, 3};

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

// --- JPEG

std::string bytes_of(const std::vector<int>& values) {
    std::string bytes;
    for (const int value : values) bytes += static_cast<char>(value);
    return bytes;
}

/// 8 x 8 pixels of one colour. A quantisation table of 8s makes the code of a block its first coefficient plus 128; the
/// Huffman tables have symbol 7 as "0" and 0 as "10", and the end of a block as "0".
std::string jpeg(int components, const std::string& data) {
    std::string bytes = bytes_of({0xFF, 0xD8, 0xFF, 0xDB, 0, 67, 0}) + std::string(64, '\x08');
    bytes += bytes_of({0xFF, 0xC0, 0, 8 + 3 * components, 8, 0, 8, 0, 8, components});
    for (int i = 1; i <= components; ++i) bytes += bytes_of({i, 0x11, 0});
    bytes += bytes_of({0xFF, 0xC4, 0, 21, 0x00, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 0});
    bytes += bytes_of({0xFF, 0xC4, 0, 20, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    bytes += bytes_of({0xFF, 0xDA, 0, 6 + 2 * components, components});
    for (int i = 1; i <= components; ++i) bytes += bytes_of({i, 0});
    return bytes + bytes_of({0, 63, 0}) + data + bytes_of({0xFF, 0xD9});
}
/// 128 + 72: "0" 1001000 "0".
std::string grey_jpeg() { return jpeg(1, bytes_of({0x48, 0x7F})); }
/// Y = 128: "10" "0"; Cb = 128: the same; Cr = 128 + 64: "0" 1000000 "0".
std::string colour_jpeg() { return jpeg(3, bytes_of({0x91, 0x01})); }

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

// --- Scene-referred formats

TEST(TextureImage, ScenePicturesGiveTheirNumbers) {
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

TEST(TextureImage, ExrNumbersAreThoseOfTheirSpace) {
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

TEST(TextureImage, AnExrOfOneChannelIsGrey) {
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

TEST(TextureImage, TheAlphaOfAnExrIsItsNumber) {
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

// --- Sides that are no powers of two

TEST(TextureImage, TexturesAreEnlargedToPowersOfTwo) {
    // 0 0.25 1 of three columns to four: weights by hand of sinc(x) sinc(x / 2) at 3/8 and 9/8 of a column.
    const std::string picture = png_bytes({.width = 3, .colour_type = 0}, std::array{0, 64, 255});
    const auto sinc = [](double x) { return x == 0.0 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); };
    const auto weight = [&](double x) { return std::abs(x) < 2.0 ? sinc(x) * sinc(x / 2.0) : 0.0; };
    const std::array value = {0.0, 64 / 255.0, 1.0};
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::black}) {
        const Image<float> numbers =
            read_number_texels("x.png", picture, LinearTransfer{}, TextureFilter::bilinear, wrap);
        ASSERT_EQ(numbers.width(), 4);
        ASSERT_EQ(numbers.height(), 1);
        for (int x = 0; x < 4; ++x) {
            const double centre = (x + 0.5) * 0.75;
            double sum = 0.0, weights = 0.0;
            for (int i = -3; i < 6; ++i) {
                const int inside = wrap == TextureWrap::repeat ? (i + 3) % 3 : std::clamp(i, 0, 2);
                const bool is_black = wrap == TextureWrap::black && inside != i;
                sum += is_black ? 0.0 : weight(i + 0.5 - centre) * value.at(static_cast<std::size_t>(inside));
                weights += weight(i + 0.5 - centre);
            }
            // What goes beyond is cut off, as codes of 8 bits can't hold it; the rest is such a code.
            const double expected = std::clamp(sum / weights, 0.0, 1.0);
            EXPECT_NEAR(numbers(x, 0), std::round(255.0 * expected) / 255.0, 1e-6) << x;
        }
    }
}

TEST(TextureImage, EnlargedTexelsOfSixteenBitsAreNotRounded) {
    const std::string picture =
        png_bytes({.width = 1, .height = 3, .bits = 16, .colour_type = 0}, std::array{0, 0, 65535});
    const Image<RGB> texels = read_rgb_texels("x.png", picture, LinearTransfer{}, TextureWrap::clamp).texels;
    ASSERT_EQ(texels.width(), 1);
    ASSERT_EQ(texels.height(), 4);
    EXPECT_LT(texels(0, 1).g, -0.001f) << "the filter goes beyond";
    EXPECT_GT(texels(0, 3).g, 1.001f);
    // As lights are: no wrap, no change.
    EXPECT_EQ(read_rgb_texels("x.png", picture, LinearTransfer{}).texels.height(), 3);
}

TEST(TextureImage, WhatFitsIsNotEnlarged) {
    const std::string picture = png_bytes({.width = 2, .height = 2}, kFourColours);
    const Image<RGB> as_is = read_rgb_texels("x.png", picture).texels;
    EXPECT_EQ(read_rgb_texels("x.png", picture, {}, TextureWrap::repeat).texels, as_is);
}

TEST(TextureImage, EvenPicturesStayEvenWhenEnlarged) {
    const std::string picture = png_bytes({.width = 5, .height = 3}, std::vector<int>(45, 77));
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::octahedral_sphere}) {
        const Image<RGB> texels = read_rgb_texels("x.png", picture, {}, wrap).texels;
        ASSERT_EQ(texels.width(), 8);
        ASSERT_EQ(texels.height(), 4);
        for (const RGB& texel : texels.pixels()) {
            expect_rgb(texel, srgb_decoded(77 / 255.0), srgb_decoded(77 / 255.0), srgb_decoded(77 / 255.0));
        }
    }
}

TEST(TextureImage, RadianceNumbersAreThoseOfTheFile) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.file("x.hdr");
    // (128, 64, 32) * 2^-8, whatever the exposure was.
    write_text(path, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=4\nCOLORCORR=1 2 1\n\n-Y 1 +X 1\n" +
                         bytes_of({128, 64, 32, 128}));
    expect_rgb(read_rgb_texels(path, read_text(path)).texels(0, 0), 0.5, 0.25, 0.125, 0.002);
}

TEST(TextureImage, TexelsMustBeFinite) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.file("x.pfm");
    Image<XYZ> xyz(2, 1);
    xyz(1, 0).y = INFINITY;
    write_pfm(path, xyz);
    const std::string message = error_of(path.string(), read_text(path));
    EXPECT_EQ(message.substr(0, message.find("found")), path.string() + ": texel (1, 0): ");
}

// --- What is no picture

TEST(TextureImage, TheNameTellsTheFormat) {
    EXPECT_EQ(error_of("x.tga", ""), "x.tga: a name that ends in none of .png .jpg .jpeg .hdr .pfm .exr");
    EXPECT_EQ(error_of("png", ""), "png: a name that ends in none of .png .jpg .jpeg .hdr .pfm .exr");
    EXPECT_EQ(error_of("x.png", grey_jpeg()), "x.png: byte 0: found another signature, expected that of a PNG picture");
    EXPECT_EQ(error_of("x.jpg", png_bytes({}, std::array{1, 2, 3})),
              "x.jpg: byte 0: found another signature, expected that of a JPEG picture");
}

TEST(TextureImage, TruncatedFilesAreErrors) {
    const std::string png = png_bytes({.width = 2, .height = 2}, kFourColours), jpg = colour_jpeg();
    ASSERT_EQ(error_of("x.png", png), "(no error)");
    ASSERT_EQ(error_of("x.jpg", jpg), "(no error)");
    for (std::size_t size = 0; size < png.size(); ++size) {
        EXPECT_NE(error_of("x.png", png.substr(0, size)), "(no error)") << size;
    }
    for (std::size_t size = 0; size < jpg.size(); ++size) {
        EXPECT_NE(error_of("x.jpg", jpg.substr(0, size)), "(no error)") << size;
    }
    EXPECT_EQ(error_of("x.png", png.substr(0, png.size() - 1)),
              "x.png: byte 81: found the end of the file in 0 bytes, expected 1 more");
    EXPECT_EQ(error_of("x.png", ""), "x.png: byte 0: found another signature, expected that of a PNG picture");
}

TEST(TextureImage, EveryDamagedBitOfAPngIsFound) {
    const std::string png = png_bytes({.width = 2, .height = 2}, kFourColours);
    for (std::size_t i = 0; i < png.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = png;
            damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
            EXPECT_NE(error_of("x.png", damaged), "(no error)") << i << " " << bit;
        }
    }
}

TEST(TextureImage, HugePicturesAreRefusedBeforeTheyAreDecoded) {
    const std::array codes = {1, 2, 3};
    EXPECT_EQ(error_of("x.png", png_bytes({.width = 16384, .height = 8193}, codes)),
              "x.png: 16384 x 8193 pixels, expected at most 134217728 in all");
    // stb_image has a limit of its own, 2^24 a side, and one at 0.
    for (const std::uint32_t width : {0x7FFFFFFFu, 0xFFFFFFFFu, 0u}) {
        EXPECT_EQ(error_of("x.png", png_bytes({.width = width, .height = 1}, codes)),
                  "x.png: is no picture that can be decoded (unknown image type)");
    }
}

TEST(TextureImage, PicturesWithTooFewPixelsAreErrors) {
    const std::array codes = {1, 2, 3};
    EXPECT_EQ(error_of("x.png", png_bytes({.width = 2, .height = 1}, codes)),
              "x.png: is no picture that can be decoded (not enough pixels)");
}

TEST(TextureImage, HuffmanTablesOfTooManyCodesAreErrors) {
    // 2 + 17 + 3000 bytes, of 16 lengths with 187 or 188 codes each.
    std::string table = bytes_of({0xFF, 0xD8, 0xFF, 0xC4, 3019 / 256, 3019 % 256, 0x10});
    for (int i = 0; i < 16; ++i) table += static_cast<char>(i < 8 ? 188 : 187);
    EXPECT_EQ(error_of("x.jpg", table + std::string(3000, '\1')),
              "x.jpg: byte 23: found a Huffman table of 3000 codes, expected at most 256");
    EXPECT_EQ(error_of("x.jpg", bytes_of({0xFF, 0xD8, 0xFF, 0xC4, 0, 5, 0, 0, 0})),
              "x.jpg: byte 6: found a piece of a Huffman table, expected a whole one");
}

/// Whatever they do to the decoder, damaged files are pictures or errors. The sanitizers watch.
TEST(TextureImage, DamagedFilesDoNoHarm) {
    Pcg32 random(1);
    const auto below = [&](std::size_t limit) { return random.next() % limit; };
    const std::array<std::pair<std::string, std::string>, 2> files = {
        {{"x.jpg", colour_jpeg()}, {"y.jpg", grey_jpeg()}}};
    for (const auto& [name, whole] : files) {
        for (int i = 0; i < 4000; ++i) {
            std::string bytes = whole;
            for (std::size_t edits = 1 + below(4); edits > 0; --edits) {
                bytes[below(bytes.size())] = static_cast<char>(below(256));
            }
            try {
                const CodedImage image = decode_jpeg(name, bytes);
                EXPECT_EQ(image.code.size(), static_cast<std::size_t>(image.width * image.height * image.channels));
            } catch (const IoError&) {
            }
        }
    }
}

}  // namespace
}  // namespace emulsion
