#include "display/png_color.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "display/png_file.h"
#include "png_chunks.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

ColorEncoding encoding(const char* space, const TransferFunction& transfer, const CodeRange& range = FullRange{}) {
    return {rgb_space(space), transfer, range};
}

/// Of a file with this encoding.
std::vector<Chunk> chunks_with(const ColorEncoding& color, int bits = 8) {
    const TemporaryFolder folder;
    write_png(folder.file("a.png"), Image<CodeRGB>(3, 2), {.bits = bits, .color = color});
    return chunks_of(read_text(folder.file("a.png")));
}

/// Of all chunks before the picture, without IHDR.
std::vector<std::string> types_with(const ColorEncoding& color) {
    std::vector<std::string> types;
    for (const Chunk& chunk : chunks_with(color)) types.push_back(chunk.type);
    EXPECT_THAT(std::vector<std::string>(types.end() - 2, types.end()), ElementsAre("IDAT", "IEND"));
    return {types.begin() + 1, types.end() - 2};
}

std::string message_of(const ColorEncoding& color) {
    try {
        (void)png_color(color);
        return "no error";
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(PngColor, TheShortestChunksThatSayAll) {
    EXPECT_THAT(types_with(encoding("Rec709", SrgbTransfer{})), ElementsAre("gAMA", "sRGB", "cHRM"));
    EXPECT_THAT(types_with(encoding("DCI_P3", GammaTransfer{2.6})), ElementsAre("gAMA", "cHRM"));
    EXPECT_THAT(types_with(encoding("Adobe_RGB_1998", AdobeRgbTransfer{})), ElementsAre("gAMA", "cHRM"));
    EXPECT_THAT(types_with(encoding("sRGB", LinearTransfer{})), ElementsAre("gAMA", "cHRM"));
    EXPECT_THAT(types_with(encoding("Rec709", Bt1886Transfer{})), ElementsAre("gAMA", "cHRM"));
    EXPECT_THAT(types_with(encoding("Rec709", Bt1886Transfer{.black_cdm2 = 0.1})), ElementsAre("iCCP"));
    EXPECT_THAT(types_with(encoding("Display_P3", SrgbTransfer{})), ElementsAre("iCCP"));
    EXPECT_THAT(types_with(encoding("ROMM_ProPhoto", ProPhotoTransfer{})), ElementsAre("iCCP"));
    EXPECT_THAT(types_with(encoding("ACEScg_AP1", LinearTransfer{})), ElementsAre("iCCP"));      // x + y > 1
    EXPECT_THAT(types_with(encoding("ACES2065_1_AP0", LinearTransfer{})), ElementsAre("iCCP"));  // y < 0
    EXPECT_THAT(types_with(encoding("Rec2020", PqTransfer{})), ElementsAre("cICP"));
    EXPECT_THAT(types_with(encoding("sRGB", SrgbTransfer{}, NarrowRange{})), ElementsAre("cICP"));
}

TEST(PngColor, NumbersOfPurePowers) {
    const std::vector<Chunk> chunks = chunks_with(encoding("DCI_P3", GammaTransfer{2.6}));
    EXPECT_EQ(big_endian(data_of(chunks, "gAMA")), 38462u);  // 1e5 / 2.6
    std::vector<std::uint32_t> values;
    for (std::size_t i = 0; i < 32; i += 4) values.push_back(big_endian(data_of(chunks, "cHRM").substr(i)));
    EXPECT_THAT(values, ElementsAre(31400, 35100, 68000, 32000, 26500, 69000, 15000, 6000));
    EXPECT_EQ(big_endian(data_of(chunks_with(encoding("sRGB", AdobeRgbTransfer{})), "gAMA")), 45471u);  // 1e5 256/563
    EXPECT_EQ(big_endian(data_of(chunks_with(encoding("sRGB", LinearTransfer{})), "gAMA")), 100000u);
}

TEST(PngColor, NumbersOfH273) {
    const auto points = [](const char* space, const TransferFunction& transfer, const CodeRange& range) {
        const std::string data = data_of(chunks_with(encoding(space, transfer, range)), "cICP");
        return std::vector<int>(data.begin(), data.end());
    };
    EXPECT_THAT(points("Rec2020", PqTransfer{}, FullRange{}), ElementsAre(9, 16, 0, 1));
    EXPECT_THAT(points("Rec2020", HlgTransfer{}, NarrowRange{}), ElementsAre(9, 18, 0, 0));
    EXPECT_THAT(points("Display_P3", PqTransfer{}, FullRange{}), ElementsAre(12, 16, 0, 1));
    EXPECT_THAT(points("DCI_P3", PqTransfer{}, FullRange{}), ElementsAre(11, 16, 0, 1));
    EXPECT_THAT(points("sRGB", SrgbTransfer{}, NarrowRange{}), ElementsAre(1, 13, 0, 0));
    EXPECT_THAT(points("Rec709", Bt709Transfer{}, NarrowRange{}), ElementsAre(1, 1, 0, 0));
    EXPECT_THAT(points("PAL_SECAM", GammaTransfer{2.8}, NarrowRange{}), ElementsAre(5, 5, 0, 0));
    EXPECT_THAT(points("SMPTE_C", GammaTransfer{2.2}, NarrowRange{}), ElementsAre(6, 4, 0, 0));
    EXPECT_THAT(points("Rec2020", Bt2020Transfer{}, NarrowRange{}), ElementsAre(9, 15, 0, 0));
    EXPECT_THAT(points("Rec2020", LinearTransfer{}, NarrowRange{}), ElementsAre(9, 8, 0, 0));
}

TEST(PngColor, WhatNoChunkSaysIsAnError) {
    EXPECT_THAT(message_of(encoding("Adobe_RGB_1998", PqTransfer{})),
                AllOf(HasSubstr("transfer pq"), HasSubstr("primaries and white of Adobe_RGB_1998; expected"),
                      HasSubstr("Rec2020")));
    EXPECT_THAT(message_of(encoding("sRGB", GammaTransfer{2.4}, NarrowRange{})),
                AllOf(HasSubstr("range narrow"), HasSubstr("transfer gamma:exponent=2.4; expected")));
    EXPECT_THAT(message_of(encoding("sRGB", Bt1886Transfer{}, NarrowRange{})), HasSubstr("transfer bt1886"));
    RgbSpace line = rgb_space("sRGB");
    line.green = {0.395, 0.195};  // between red and blue
    EXPECT_NE(message_of({line, SrgbTransfer{}, FullRange{}}), "no error");
    // Found before any work, and the file is not begun.
    EXPECT_THROW(validate({.color = encoding("Adobe_RGB_1998", PqTransfer{})}), std::invalid_argument);
    EXPECT_THROW(validate({.bits = 7, .color = encoding("Rec709", SrgbTransfer{}, NarrowRange{})}),
                 std::invalid_argument);
    EXPECT_NO_THROW(validate(PngOptions{}));
}

// 10 bits: black is 64 and white 940; in a file of 16 bits they are 4096 and 60160, as for 16 bits themselves.
TEST(PngColor, NarrowCodesAreShifted) {
    const TemporaryFolder folder;
    Image<CodeRGB> image(1, 1);
    image(0, 0) = {64, 940, 65};
    write_png(folder.file("a.png"), image,
              {.bits = 10, .color = encoding("Rec2020", PqTransfer{}, NarrowRange{}), .level = 0});
    const std::vector<Chunk> chunks = chunks_of(read_text(folder.file("a.png")));
    EXPECT_EQ(data_of(chunks, "sBIT"), "\x0a\x0a\x0a");
    // Stored: 2 bytes of zlib, 5 of the block, the filter's number.
    const std::string samples = data_of(chunks, "IDAT").substr(8, 6);
    EXPECT_EQ(samples, std::string("\x10\x00\xeb\x00\x10\x40", 6));
}

/// What the program says of the file, and its exit code; -1 if there is no such program.
std::pair<int, std::string> said_by(const std::string& command) {
    const TemporaryFolder folder;
    const std::string out = folder.file("out");
    const int status = std::system((command + " >'" + out + "' 2>&1").c_str());  // NOLINT(cert-env33-c)
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return {code == 127 ? -1 : code, read_text(out)};
}

std::vector<ColorEncoding> one_of_each() {
    return {encoding("sRGB", SrgbTransfer{}), encoding("DCI_P3", GammaTransfer{2.6}),
            encoding("Display_P3", SrgbTransfer{}), encoding("Rec2020", PqTransfer{})};
}

/// Pure powers with primaries at the ends of what cHRM has, in and out.
std::vector<ColorEncoding> with_far_primaries() {
    std::vector<ColorEncoding> all;
    for (const double y : {0.7999, 0.8, 0.80001, 0.8264, 1.0}) {
        all.push_back({{"far", {0.7347, 0.2653}, {0.0, y}, {0.1566, 0.0177}, {0.3127, 0.329}}, GammaTransfer{2.2}, {}});
        all.push_back({{"far", {y, 1.0 - y}, {0.2, 0.7}, {0.1566, 0.0177}, {0.3127, 0.329}}, LinearTransfer{}, {}});
    }
    for (const char* space : {"ACES2065_1_AP0", "ROMM_ProPhoto", "Rec2020", "ACEScg_AP1"}) {
        all.push_back(encoding(space, GammaTransfer{1.8}));
    }
    return all;
}

TEST(PngColor, PrimariesAbove0_8AreSaidByAProfile) {
    for (const ColorEncoding& color : with_far_primaries()) {
        const RgbSpace& space = color.space;
        const bool fits = std::max({space.red.x, space.green.y}) <= 0.8 && space.blue.y >= 0.0;
        EXPECT_EQ(std::holds_alternative<PngGamma>(png_color(color)), fits) << space.red.x << ' ' << space.green.y;
    }
}

TEST(PngColor, PngcheckIsContent) {
    if (said_by("pngcheck -h").first == -1) GTEST_SKIP() << "pngcheck is not installed";
    const TemporaryFolder folder;
    std::vector<ColorEncoding> all = one_of_each();
    for (const ColorEncoding& color : with_far_primaries()) all.push_back(color);
    for (const ColorEncoding& color : all) {
        write_png(folder.file("a.png"), Image<CodeRGB>(3, 2),
                  {.color = color, .text = {{"Pipeline", "tonemap=zone"}, {"Author", "caf\xc3\xa9"}}});
        const auto [code, text] = said_by("pngcheck -q '" + folder.file("a.png") + "'");
        // pngcheck 3.0.3, of 2020, is older than cICP and reports that one as unknown, which ends its check.
        const bool knows_all = text.find("unknown, public chunk cICP") == std::string::npos;
        if (!knows_all && std::holds_alternative<PngCodePoints>(png_color(color))) continue;
        EXPECT_EQ(code, 0) << color.space.name;
        EXPECT_EQ(text, "") << color.space.name;
    }
}

TEST(PngColor, ImageMagickReadsTheSameValues) {
    if (said_by("identify -version").first != 0) GTEST_SKIP() << "ImageMagick's identify is not installed";
    const TemporaryFolder folder;
    Image<CodeRGB> image(2, 1);
    image(0, 0) = {1, 200, 77};
    image(1, 0) = {255, 0, 128};
    for (const ColorEncoding& color : one_of_each()) {
        const std::string file = folder.file("a.png");
        write_png(file, image, {.color = color});
        const auto [code, text] = said_by(
            "identify -format '%[fx:int(255*u.p{0,0}.r+.5)] %[fx:int(255*u.p{0,0}.g+.5)] "
            "%[fx:int(255*u.p{1,0}.b+.5)]' '" +
            file + "'");
        EXPECT_EQ(code, 0) << text;
        EXPECT_EQ(text, "1 200 128") << color.space.name;
    }
}

}  // namespace
}  // namespace emulsion
