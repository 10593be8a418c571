#include "film/radiance_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "film/exr_file.h"
#include "film/rgbe.h"
#include "spectrum/rgb_space.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

using std::string_literals::operator""s;

std::array<double, 3> rec709_of(const XYZ& xyz) {
    return rgb_from_xyz(rgb_space("Rec709")) * std::array<double, 3>{xyz.x, xyz.y, xyz.z};
}
XYZ xyz_of_rgb(const RGBd& rgb) {
    const auto xyz = xyz_from_rgb(rgb_space("Rec709")) * std::array{rgb.r, rgb.g, rgb.b};
    return {static_cast<float>(xyz[0]), static_cast<float>(xyz[1]), static_cast<float>(xyz[2])};
}

ScenePicture read_bytes(const std::string& bytes) {
    const TemporaryFolder folder;
    write_text(folder.file("a.hdr"), bytes);
    return read_radiance(folder.file("a.hdr"));
}

std::string message_of(const std::string& bytes) {
    try {
        (void)read_bytes(bytes);
        return "no error";
    } catch (const IoError& error) {
        return error.reason();
    }
}

/// Red, green and blue of 2^k / 256, with the exponent byte of k + 128, as a picture's values.
void expect_rgb(const XYZ& found, const std::array<double, 3>& expected) {
    const auto rgb = rec709_of(found);
    const double largest = *std::max_element(expected.begin(), expected.end());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(rgb[i], expected[i], 1e-6 * largest) << i;
}

const std::string kStart = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

/// Flat parts, ramps and noise, over many decades, inside Rec. 709.
Image<XYZ> picture(int width, int height) {
    Pcg32 random(90);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random.next()), -32); };
    Image<XYZ> image(width, height);
    for (int y = 0; y < height; ++y) {
        const double scale = std::exp2(20.0 * unit() - 10.0);
        for (int x = 0; x < width; ++x) {
            const bool flat = (x / 9) % 2 == 0;
            const RGBd rgb = flat ? RGBd{0.25, 1.0, 0.5} : RGBd{unit(), unit(), unit()};
            image(x, y) = xyz_of_rgb({scale * rgb.r, scale * rgb.g, scale * rgb.b});
        }
    }
    return image;
}

// The stated error; the widths are those that have run lengths, and those that don't.
TEST(RadianceFile, ReadsBackWithinTheStatedError) {
    const TemporaryFolder folder;
    for (const int width : {1, 7, 8, 300, 32767, 32768}) {
        const Image<XYZ> image = picture(width, 4);
        EXPECT_EQ(write_radiance(folder.file("a.hdr"), image), RadianceWriteResult{});
        const ScenePicture read = read_radiance(folder.file("a.hdr"));
        ASSERT_EQ(read.xyz.width(), width);
        for (std::size_t i = 0; i < image.pixels().size(); ++i) {
            const auto expected = rec709_of(image.pixels()[i]), found = rec709_of(read.xyz.pixels()[i]);
            const double largest = *std::max_element(expected.begin(), expected.end());
            // 1/255.5, and 2e-6 for XYZ in single precision
            for (std::size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(found[c], expected[c], (1.0 / 255.5 + 2e-6) * largest) << width;
        }
        EXPECT_THAT(read.notes, ElementsAre(HasSubstr("1 cd/m^2")));  // the primaries are in the file
    }
    EXPECT_THAT(folder.names(), ElementsAre("a.hdr"));
}

TEST(RadianceFile, RunsAreShort) {
    const TemporaryFolder folder;
    Image<XYZ> flat(1000, 1);
    std::fill(flat.pixels().begin(), flat.pixels().end(), xyz_of_rgb({1, 2, 3}));
    write_radiance(folder.file("a.hdr"), flat);
    const std::string bytes = read_text(folder.file("a.hdr"));
    EXPECT_THAT(bytes, StartsWith("#?RADIANCE\n"));
    EXPECT_EQ(bytes.size() - bytes.find("+X 1000\n") - 8, 4u + 4u * 2u * 8u);  // 8 runs of up to 127
    EXPECT_EQ(read_radiance(folder.file("a.hdr")).xyz(999, 0), read_radiance(folder.file("a.hdr")).xyz(0, 0));
}

TEST(RadianceFile, RgbeIsTheNearest) {
    EXPECT_EQ(to_rgbe({1.0f, 0.5f, 0.25f}), (Rgbe{128, 64, 32, 129}));
    EXPECT_EQ(to_rgbe({0.999f, 0.0f, 0.0f}), (Rgbe{128, 0, 0, 129}));  // 255.7 / 256 rounds up to the next exponent
    EXPECT_EQ(to_rgbe({0, 0, 0}), Rgbe{});
    EXPECT_EQ(to_rgbe({0x1p-140f, 0, 0}), Rgbe{});
    EXPECT_EQ(to_rgbe({0x1p-128f, 0, 0}), (Rgbe{128, 0, 0, 1}));
    EXPECT_EQ(to_rgbe({255.0f / 256.0f * 0x1p127f, 0, 0}), (Rgbe{255, 0, 0, 255}));
    // All that are stored with a leading 1 come back as themselves.
    for (int exponent = 1; exponent < 256; ++exponent) {
        for (const int significand : {128, 129, 200, 255}) {
            const Rgbe rgbe{static_cast<std::uint8_t>(significand), 77, 0, static_cast<std::uint8_t>(exponent)};
            EXPECT_EQ(to_rgbe(from_rgbe(rgbe)), rgbe);
        }
    }
}

// Colours on the faces of Rec. 709's gamut, from XYZ in single precision: rounding puts them outside by some 1e-7.
TEST(RadianceFile, RoundingIsNoColourOutsideItsGamut) {
    const TemporaryFolder folder;
    Image<XYZ> image(64, 64);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) image(x, y) = xyz_of_rgb({100.0 * x / 63.0, y / 63.0, 0.0});
    }
    EXPECT_EQ(write_radiance(folder.file("a.hdr"), image).negative_count, 0);
    image(5, 5) = xyz_of_rgb({1.0, 0.5, -2e-6});
    EXPECT_EQ(write_radiance(folder.file("a.hdr"), image).negative_count, 1);
}

TEST(RadianceFile, CountsWhatItCannotHold) {
    const TemporaryFolder folder;
    Image<XYZ> image(4, 1);
    image(0, 0) = {0.1f, 0.3f, 0.02f};  // red and blue below 0
    image(1, 0) = {std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f};
    image(2, 0) = xyz_of_rgb({1.8e38, 1.0, 1.0});
    image(3, 0) = xyz_of_rgb({1, 1, 1});
    const RadianceWriteResult result = write_radiance(folder.file("a.hdr"), image);
    EXPECT_EQ(result.non_finite_count, 3);
    EXPECT_EQ(result.too_high_count, 1);
    EXPECT_GE(result.negative_count, 2);
    const ScenePicture read = read_radiance(folder.file("a.hdr"));
    EXPECT_EQ(read.xyz(1, 0), XYZ{});
    EXPECT_GT(rec709_of(read.xyz(2, 0))[0], 1.68e38);
    EXPECT_GE(rec709_of(read.xyz(0, 0))[0], -1e-6);
}

TEST(RadianceFile, ReadsPlainAndOldRuns) {
    const std::string pixel = "\x80\x40\x20\x81", other = "\x10\x20\x80\x82";  // (1, 0.5, 0.25), (0.25, 0.5, 2)
    const std::array<double, 3> first = {1, 0.5, 0.25}, second = {0.25, 0.5, 2};
    const ScenePicture plain = read_bytes(kStart + "-Y 1 +X 2\n" + pixel + other);
    expect_rgb(plain.xyz(0, 0), first);
    expect_rgb(plain.xyz(1, 0), second);
    EXPECT_THAT(plain.notes, ElementsAre(HasSubstr("Rec. 709"), HasSubstr("1 cd/m^2")));
    // 1 + 2 + 256 of the first, then one of the second.
    const ScenePicture runs = read_bytes(kStart + "-Y 1 +X 260\n" + pixel + "\1\1\1\2" + "\1\1\1\1" + other);
    expect_rgb(runs.xyz(258, 0), first);
    expect_rgb(runs.xyz(259, 0), second);
}

TEST(RadianceFile, ReadsNewRuns) {
    const std::string bytes = kStart + "-Y 1 +X 8\n" + "\2\2\0\x08"s +  //
                              "\x87\x80" + "\1\x40" +                   // red: 7 of 128, 1 of 64
                              "\x88\x40" + "\x08\1\2\3\4\5\6\7\x08" +   // green: 8 of 64; blue: 1 to 8
                              "\x84\x81\x84\x81";                       // exponent: 4 and 4 of 1
    const ScenePicture read = read_bytes(bytes);
    expect_rgb(read.xyz(0, 0), {1.0, 0.5, 1.0 / 128});
    expect_rgb(read.xyz(7, 0), {0.5, 0.5, 8.0 / 128});
}

TEST(RadianceFile, HonoursTheHeader) {
    const std::string pixel = "\x80\x40\x20\x81";
    const auto read = [&](const std::string& lines) {
        return read_bytes("#?RGBE\n# a comment\nOWNER=x\n" + lines + "\n-Y 1 +X 1\n" + pixel).xyz(0, 0);
    };
    expect_rgb(read("FORMAT=32-bit_rle_rgbe\nEXPOSURE=2\nEXPOSURE= 0.25\n"), {2, 1, 0.5});
    expect_rgb(read("COLORCORR=1 0.5 2\nCOLORCORR=1 0.5 1\n"), {1, 2, 0.125});
    const XYZ xyz = read("FORMAT=32-bit_rle_xyze\n");
    EXPECT_EQ(xyz, (XYZ{1.0f, 0.5f, 0.25f}));
    const XYZ wide = read("PRIMARIES=0.708 0.292 0.17 0.797 0.131 0.046 0.3127 0.329\n");
    const auto expected = xyz_from_rgb(rgb_space("Rec2020")) * std::array{1.0, 0.5, 0.25};
    EXPECT_NEAR(wide.y, expected[1], 1e-6);
    EXPECT_NEAR(wide.x, expected[0], 1e-6);
    expect_rgb(read("PRIMARIES=0 0 0 0 0 0 0 0\n"), {1, 0.5, 0.25});  // Photoshop's none
}

// Six pixels in a file, of levels 1 to 6, put where the size line says.
TEST(RadianceFile, HonoursEveryOrientation) {
    std::string pixels;
    for (int level = 1; level <= 6; ++level) pixels += std::string(3, static_cast<char>(2 * level)) + "\x87";
    // By their luminances in rows from the top left.
    const auto levels = [&](const char* size) {
        const ScenePicture read = read_bytes(kStart + size + "\n" + pixels);
        std::string text = std::to_string(read.xyz.width()) + "x" + std::to_string(read.xyz.height()) + " ";
        for (const XYZ& pixel : read.xyz.pixels()) text += std::to_string(std::lround(pixel.y));
        return text;
    };
    EXPECT_EQ(levels("-Y 2 +X 3"), "3x2 123456");
    EXPECT_EQ(levels("+Y 2 +X 3"), "3x2 456123");
    EXPECT_EQ(levels("-Y 2 -X 3"), "3x2 321654");
    EXPECT_EQ(levels("+Y 2 -X 3"), "3x2 654321");
    EXPECT_EQ(levels("+X 3 -Y 2"), "3x2 135246");
    EXPECT_EQ(levels("+X 3 +Y 2"), "3x2 246135");
    EXPECT_EQ(levels("-X 3 -Y 2"), "3x2 531642");
    EXPECT_EQ(levels("-X 3 +Y 2"), "3x2 642531");
}

TEST(RadianceFile, ErrorsNamePlaceValueAndWhatWasExpected) {
    const std::string size = "\n-Y 1 +X 1\nabcd";
    EXPECT_EQ(message_of("P3\n"), "Radiance header, line 1: found \"P3\", expected #?RADIANCE");
    EXPECT_EQ(message_of("#?RADIANCE\nFORMAT=16-bit\n" + size),
              "Radiance header, line 2: found FORMAT \"16-bit\", expected 32-bit_rle_rgbe or 32-bit_rle_xyze");
    EXPECT_THAT(message_of("#?RADIANCE\nEXPOSURE=0\n" + size),
                HasSubstr("line 2: found \"0\", expected an EXPOSURE above 0"));
    EXPECT_THAT(message_of("#?RADIANCE\nEXPOSURE=1e400\n" + size), HasSubstr("expected an EXPOSURE above 0"));
    EXPECT_THAT(message_of("#?RADIANCE\n\nCOLORCORR=1 2"), HasSubstr("line 3: found no end of the line"));
    EXPECT_THAT(message_of("#?RADIANCE\nCOLORCORR=1 2\n" + size),
                HasSubstr("found \"1 2\", expected a COLORCORR of three"));
    EXPECT_THAT(message_of("#?RADIANCE\nPRIMARIES=.1 .1 .2 .2 .3 .3 .3 .3\n" + size), HasSubstr("not on one line"));
    for (const char* line : {"-Y 0 +X 1", "-Y 1 +X 1048577", "-Y 1 +Y 1", "-Y 1", "Y 1 X 1", "-Y 1 +X 1 3"}) {
        EXPECT_THAT(message_of("#?RADIANCE\n\n"s + line + "\nabcd"), HasSubstr("line 3: found \""s + line)) << line;
    }
    EXPECT_EQ(message_of(kStart + "-Y 2 +X 1\nabcdabc"),
              "Radiance scan line 2, byte 52 of the file: found the end of the file, expected more pixels");
    EXPECT_THAT(message_of(kStart + "-Y 1 +X 8\n\2\2\0\x09"s), HasSubstr("found 9 pixels, expected 8"));
    EXPECT_THAT(message_of(kStart + "-Y 1 +X 8\n\2\2\0\x08\x89\1"s), HasSubstr("found a run of 9, expected 1 to 8"));
    EXPECT_THAT(message_of(kStart + "-Y 1 +X 8\n\2\2\0\x08\0\1"s), HasSubstr("found a run of 0"));
    EXPECT_THAT(message_of(kStart + "-Y 1 +X 3\n\1\1\1\1"),
                HasSubstr("found a repetition, expected a pixel to repeat"));
    EXPECT_THAT(message_of(kStart + "-Y 1 +X 3\nabcd\1\1\1\5"), HasSubstr("found a run of 5, expected at most 2"));
    EXPECT_THAT(message_of(kStart + "-Y 1048576 +X 1048576\nabcd"), HasSubstr("scan line 1, byte"));
}

TEST(RadianceFile, WritesWholeOrNotAtAll) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_radiance(folder.file("nowhere") + "/a.hdr", Image<XYZ>(1, 1)), IoError);
    EXPECT_THROW(write_radiance(folder.file("a.hdr"), Image<XYZ>()), std::invalid_argument);
    EXPECT_THAT(folder.names(), IsEmpty());
}

// Another's reader sees the values that ours does.
TEST(RadianceFile, OpenImageIOReadsTheSameValues) {
    const TemporaryFolder folder;
    write_radiance(folder.file("a.hdr"), picture(300, 20));
    const std::string command =
        "oiiotool '" + folder.file("a.hdr") + "' -d float -o '" + folder.file("a.exr") + "' >/dev/null 2>&1";
    if (std::system("oiiotool --help >/dev/null 2>&1") != 0) GTEST_SKIP() << "oiiotool is not installed";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const ScenePicture ours = read_radiance(folder.file("a.hdr"));
    const FilmImage theirs = read_exr(folder.file("a.exr"));
    ASSERT_EQ(theirs.xyz.width(), 300);
    for (std::size_t i = 0; i < ours.xyz.pixels().size(); ++i) {
        const double y = ours.xyz.pixels()[i].y;
        ASSERT_NEAR(theirs.xyz.pixels()[i].y, y, 1e-6 * y);
    }
}

}  // namespace
}  // namespace emulsion
