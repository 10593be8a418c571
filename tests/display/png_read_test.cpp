#include "display/png_read.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>

#include "core/error.h"
#include "core/random.h"
#include "display/png_file.h"
#include "spectrum/rgb_space.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What encodings make of codes, by the definition.
XYZd expected_xyz(const CodeRGB& code, int bits, const RgbSpace& space, const TransferFunction& transfer) {
    const auto linear = [&](int component) { return decode(transfer, component / (std::exp2(bits) - 1.0)); };
    const auto v = xyz_from_rgb(space) * std::array{linear(code.r), linear(code.g), linear(code.b)};
    return {v[0], v[1], v[2]};
}

TEST(PngRead, DecodesBySrgbOrByGammaAndPrimaries) {
    const TemporaryFolder folder;
    Pcg32 random(80);
    for (const int bits : {8, 16}) {
        for (const auto& [name, transfer] : {std::pair<const char*, TransferFunction>{"sRGB", SrgbTransfer{}},
                                             {"DCI_P3", GammaTransfer{2.6}},
                                             {"sRGB", LinearTransfer{}}}) {
            Image<CodeRGB> image(40, 30);
            const auto code = [&] {
                return static_cast<std::uint16_t>(random.next() >> (32u - static_cast<unsigned>(bits)));
            };
            for (CodeRGB& pixel : image.pixels()) pixel = {code(), code(), code()};
            const RgbSpace& space = rgb_space(name);
            write_png(folder.file("a.png"), image, {.bits = bits, .color = {space, transfer, FullRange{}}});
            const PngPicture read = read_png(folder.file("a.png"));
            EXPECT_THAT(read.notes, IsEmpty());
            ASSERT_EQ(read.xyz.width(), 40);
            // gAMA is rounded to 5e-6 of about 0.4: 1.3e-5 of the exponent, 1.3e-5 ln(1/v) v^g at most 5e-6 for XYZ.
            for (std::size_t i = 0; i < image.pixels().size(); ++i) {
                const XYZd expected = expected_xyz(image.pixels()[i], bits, space, transfer);
                ASSERT_NEAR(read.xyz.pixels()[i].x, expected.x, 1e-5) << name;
                ASSERT_NEAR(read.xyz.pixels()[i].y, expected.y, 1e-5) << name;
                ASSERT_NEAR(read.xyz.pixels()[i].z, expected.z, 1e-5) << name;
            }
        }
    }
}

/// By libpng: a picture of any type, with what `before` adds.
void write_with(const std::string& path, int color_type, int depth, int interlace, const std::vector<png_byte>& row,
                int width, int height, const std::function<void(png_structp, png_infop)>& before = {}) {
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "wb"), &std::fclose);
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, stream.get());
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), depth, color_type,
                 interlace, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (before) before(png, info);
    png_write_info(png, info);
    std::vector<png_byte> copy = row;
    std::vector<png_bytep> rows(static_cast<std::size_t>(height), copy.data());
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
}

TEST(PngRead, ReadsEveryKindOfPng) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.png");
    const double red = xyz_from_rgb(rgb_space("sRGB")).m[1][0];

    write_with(file, PNG_COLOR_TYPE_GRAY, 1, PNG_INTERLACE_NONE, {0x40}, 2, 1);
    PngPicture read = read_png(file);
    EXPECT_NEAR(read.xyz(0, 0).y, 0.0, 1e-6);
    EXPECT_NEAR(read.xyz(1, 0).y, 1.0, 1e-6);
    EXPECT_THAT(read.notes, ElementsAre(HasSubstr("taken as sRGB")));

    const auto palette = [](png_structp png, png_infop info) {
        const png_color colors[] = {{0, 0, 0}, {255, 0, 0}};
        png_set_PLTE(png, info, colors, 2);
    };
    write_with(file, PNG_COLOR_TYPE_PALETTE, 8, PNG_INTERLACE_NONE, {1}, 1, 1, palette);
    EXPECT_NEAR(read_png(file).xyz(0, 0).y, red, 1e-6);

    write_with(file, PNG_COLOR_TYPE_RGB_ALPHA, 8, PNG_INTERLACE_ADAM7, {255, 0, 0, 7, 255, 255, 255, 0}, 2, 9);
    read = read_png(file);
    EXPECT_NEAR(read.xyz(0, 8).y, red, 1e-6);
    EXPECT_NEAR(read.xyz(1, 3).y, 1.0, 1e-6);
    EXPECT_THAT(read.notes, ElementsAre("its alpha was left out", HasSubstr("taken as sRGB")));

    write_with(file, PNG_COLOR_TYPE_GRAY_ALPHA, 16, PNG_INTERLACE_NONE, {0x80, 0x00, 0, 0}, 1, 1,
               [](png_structp png, png_infop info) { png_set_gAMA(png, info, 0.5); });
    read = read_png(file);
    EXPECT_NEAR(read.xyz(0, 0).y, std::pow(32768.0 / 65535.0, 2.0), 1e-6);
    EXPECT_THAT(read.notes, ElementsAre("its alpha was left out", HasSubstr("no cHRM")));
}

TEST(PngRead, SaysWhatItLeavesOutOrRefuses) {
    const TemporaryFolder folder;
    const Image<CodeRGB> image(2, 2);
    write_png(folder.file("icc.png"), image, {.color = {rgb_space("Display_P3"), SrgbTransfer{}, FullRange{}}});
    EXPECT_THAT(read_png(folder.file("icc.png")).notes, ElementsAre(HasSubstr("ICC profile was left out")));
    write_png(folder.file("pq.png"), image, {.color = {rgb_space("Rec2020"), PqTransfer{}, FullRange{}}});
    EXPECT_THAT([&] { (void)read_png(folder.file("pq.png")); },
                testing::ThrowsMessage<IoError>(HasSubstr("with a cICP chunk, which is not read; expected sRGB")));
    write_with(folder.file("gamma.png"), PNG_COLOR_TYPE_GRAY, 8, PNG_INTERLACE_NONE, {1}, 1, 1,
               [](png_structp png, png_infop info) { png_set_gAMA(png, info, 0.1); });
    EXPECT_THAT([&] { (void)read_png(folder.file("gamma.png")); },
                testing::ThrowsMessage<IoError>(HasSubstr("gAMA 0.1")));
    EXPECT_THROW((void)read_png(folder.file("none.png")), IoError);
    write_text(folder.file("text.png"), "no PNG at all");
    EXPECT_THAT([&] { (void)read_png(folder.file("text.png")); }, testing::ThrowsMessage<IoError>(HasSubstr("PNG")));
}

}  // namespace
}  // namespace emulsion
