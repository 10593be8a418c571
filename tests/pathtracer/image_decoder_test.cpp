#include "pathtracer/image_decoder.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "core/random.h"
#include "support/png_bytes.h"
#include "texture_image_fixture.h"

namespace emulsion {
namespace {

using testing::png_bytes;

TEST(ImageDecoder, TruncatedFilesAreErrors) {
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

TEST(ImageDecoder, EveryDamagedBitOfAPngIsFound) {
    const std::string png = png_bytes({.width = 2, .height = 2}, kFourColours);
    for (std::size_t i = 0; i < png.size(); ++i) {
        for (int bit = 0; bit < 8; ++bit) {
            std::string damaged = png;
            damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
            EXPECT_NE(error_of("x.png", damaged), "(no error)") << i << " " << bit;
        }
    }
}

TEST(ImageDecoder, HugePicturesAreRefusedBeforeTheyAreDecoded) {
    const std::array codes = {1, 2, 3};
    EXPECT_EQ(error_of("x.png", png_bytes({.width = 16384, .height = 8193}, codes)),
              "x.png: 16384 x 8193 pixels, expected at most 134217728 in all");
    // stb_image has a limit of its own, 2^24 a side, and one at 0.
    for (const std::uint32_t width : {0x7FFFFFFFu, 0xFFFFFFFFu, 0u}) {
        EXPECT_EQ(error_of("x.png", png_bytes({.width = width, .height = 1}, codes)),
                  "x.png: is no picture that can be decoded (unknown image type)");
    }
}

TEST(ImageDecoder, PicturesWithTooFewPixelsAreErrors) {
    const std::array codes = {1, 2, 3};
    EXPECT_EQ(error_of("x.png", png_bytes({.width = 2, .height = 1}, codes)),
              "x.png: is no picture that can be decoded (not enough pixels)");
}

TEST(ImageDecoder, HuffmanTablesOfTooManyCodesAreErrors) {
    // 2 + 17 + 3000 bytes, of 16 lengths with 187 or 188 codes each.
    std::string table = bytes_of({0xFF, 0xD8, 0xFF, 0xC4, 3019 / 256, 3019 % 256, 0x10});
    for (int i = 0; i < 16; ++i) table += static_cast<char>(i < 8 ? 188 : 187);
    EXPECT_EQ(error_of("x.jpg", table + std::string(3000, '\1')),
              "x.jpg: byte 23: found a Huffman table of 3000 codes, expected at most 256");
    EXPECT_EQ(error_of("x.jpg", bytes_of({0xFF, 0xD8, 0xFF, 0xC4, 0, 5, 0, 0, 0})),
              "x.jpg: byte 6: found a piece of a Huffman table, expected a whole one");
}

/// Whatever they do to the decoder, damaged files are pictures or errors. The sanitizers watch.
TEST(ImageDecoder, DamagedFilesDoNoHarm) {
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
