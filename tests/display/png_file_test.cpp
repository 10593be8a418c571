#include "display/png_file.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"
#include "png_chunks.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PngFile : public testing::Test {
  protected:
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return folder_.file(name); }
    [[nodiscard]] std::vector<std::string> files() const { return folder_.names(); }

  private:
    TemporaryFolder folder_;
};

Image<CodeRGB> random_image(int width, int height, int bits = 8) {
    Pcg32 random(60);
    const auto code = [&] { return static_cast<std::uint16_t>(random.next() >> (32u - static_cast<unsigned>(bits))); };
    Image<CodeRGB> image(width, height);
    for (CodeRGB& p : image.pixels()) p = {code(), code(), code()};
    return image;
}

struct Samples {
    int depth = 0;
    Image<CodeRGB> image;
};

/// By libpng, as they stand in the file.
Samples read_back(const std::filesystem::path& path) {
    const std::string name = path.string();
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(name.c_str(), "rb"), &std::fclose);
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, stream.get());
    png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
    EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_RGB);
    Samples read{png_get_bit_depth(png, info), Image<CodeRGB>(static_cast<int>(png_get_image_width(png, info)),
                                                              static_cast<int>(png_get_image_height(png, info)))};
    for (int y = 0; y < read.image.height(); ++y) {
        const png_byte* byte = png_get_rows(png, info)[y];
        const auto sample = [&] {
            std::uint16_t value = *byte++;
            if (read.depth == 16) value = static_cast<std::uint16_t>(value << 8u | *byte++);
            return value;
        };
        for (CodeRGB& pixel : read.image.row(y)) {
            const std::uint16_t r = sample(), g = sample(), b = sample();
            pixel = {r, g, b};
        }
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return read;
}

TEST_F(PngFile, ReadsBackAsWritten) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {211, 97}}) {
        const Image<CodeRGB> image = random_image(width, height);
        write_png(file("a.png"), image);
        const Samples read = read_back(file("a.png"));
        EXPECT_EQ(read.depth, 8);
        EXPECT_EQ(read.image, image) << width << "x" << height;
    }
    EXPECT_THAT(files(), ElementsAre("a.png"));
}

TEST_F(PngFile, CodesOfAnyNumberOfBitsAreSpreadAndCanBeToldApart) {
    for (int bits = 1; bits <= 16; ++bits) {
        const Image<CodeRGB> image = random_image(301, 97, bits);
        write_png(file("a.png"), image, {.bits = bits});
        const Samples read = read_back(file("a.png"));
        EXPECT_EQ(read.depth, bits <= 8 ? 8 : 16);
        const double whole = std::exp2(read.depth) - 1.0, most = std::exp2(bits) - 1.0;
        for (std::size_t i = 0; i < image.pixels().size(); ++i) {
            ASSERT_LE(std::abs(read.image.pixels()[i].g - image.pixels()[i].g * whole / most), 0.5) << bits;
        }
        const std::string sbit = data_of(chunks_of(read_text(file("a.png"))), "sBIT");
        EXPECT_EQ(sbit, bits == 8 || bits == 16 ? "no such chunk" : std::string(3, static_cast<char>(bits)));
    }
}

// Every level holds the same samples; none packs worse than none at all. The picture has patterns and no noise.
TEST_F(PngFile, EveryLevelHoldsTheSameSamples) {
    for (const int bits : {1, 4, 5, 8, 16}) {
        Image<CodeRGB> image(120, 90);
        const int most = (1 << bits) - 1;
        for (int y = 0; y < 90; ++y) {
            for (int x = 0; x < 120; ++x) {
                const auto code = static_cast<std::uint16_t>((x * most / 119 + y % 2) % (most + 1));
                image(x, y) = {code, static_cast<std::uint16_t>(most - code), code};
            }
        }
        write_png(file("stored.png"), image, {.bits = bits, .level = 0});
        const Samples stored = read_back(file("stored.png"));
        for (int level = 1; level <= 9; ++level) {
            write_png(file("a.png"), image, {.bits = bits, .level = level});
            EXPECT_EQ(read_back(file("a.png")).image, stored.image) << bits << " bits, level " << level;
            EXPECT_LT(std::filesystem::file_size(file("a.png")), std::filesystem::file_size(file("stored.png")));
        }
    }
}

// Noise in the last bits, as dithering makes it: the default is fast because it looks for no strings, and is not to be
// larger for it than what libpng does by itself. 1.05 is the most that any measured picture of this kind had.
TEST_F(PngFile, TheDefaultLevelIsAboutAsSmallAsLibpngsOnDitheredPictures) {
    Pcg32 random(61);
    Image<CodeRGB> image(300, 200);
    for (int y = 0; y < 200; ++y) {
        for (int x = 0; x < 300; ++x) {
            const double smooth = 120.0 + 80.0 * std::sin(0.02 * x) * std::cos(0.03 * y);
            const auto dithered = [&](double light) {
                return static_cast<std::uint16_t>(light + std::ldexp(static_cast<double>(random.next()), -31));
            };
            image(x, y) = {dithered(smooth), dithered(0.8 * smooth), dithered(0.5 * smooth)};
        }
    }
    write_png(file("default.png"), image);
    write_png(file("libpng.png"), image, {.level = 6});
    EXPECT_LE(static_cast<double>(std::filesystem::file_size(file("default.png"))),
              1.05 * static_cast<double>(std::filesystem::file_size(file("libpng.png"))));
}

TEST_F(PngFile, SaysThatItIsSrgb) {
    write_png(file("a.png"), random_image(5, 4));
    const std::vector<Chunk> chunks = chunks_of(read_text(file("a.png")));
    EXPECT_EQ(data_of(chunks, "sRGB"), std::string(1, '\1'));  // relative colorimetric
    EXPECT_EQ(big_endian(data_of(chunks, "gAMA")), 45455u);
    const std::string chromaticities = data_of(chunks, "cHRM");
    ASSERT_EQ(chromaticities.size(), 32u);
    std::vector<std::uint32_t> values;
    for (std::size_t i = 0; i < 32; i += 4) values.push_back(big_endian(chromaticities.substr(i)));
    EXPECT_THAT(values, ElementsAre(31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000));
}

TEST_F(PngFile, CarriesText) {
    const PngOptions options{.text = {{"Pipeline", "tonemap=max-to-white"}, {"Command Line", "render caf\xc3\xa9"}}};
    write_png(file("a.png"), random_image(5, 4), options);
    const std::vector<Chunk> chunks = chunks_of(read_text(file("a.png")));
    using std::string_literals::operator""s;
    EXPECT_EQ(data_of(chunks, "tEXt"), "Pipeline\0tonemap=max-to-white"s);
    EXPECT_EQ(data_of(chunks, "iTXt"), "Command Line\0\0\0\0\0render caf\xc3\xa9"s);
}

TEST_F(PngFile, SamePictureSameBytes) {
    const PngOptions options{.text = {{"Pipeline", "x"}}};
    write_png(file("a.png"), random_image(64, 64), options);
    write_png(file("b.png"), random_image(64, 64), options);
    EXPECT_EQ(read_text(file("a.png")), read_text(file("b.png")));
}

TEST_F(PngFile, RejectsBadArguments) {
    const Image<CodeRGB> image = random_image(2, 2);
    const auto write_with = [&](PngText text) { write_png(file("a.png"), image, {.text = {std::move(text)}}); };
    for (const char* keyword : {"", " a", "a ", "a  b", "a\n", "caf\xc3\xa9"}) {
        EXPECT_THROW(write_with({keyword, "text"}), std::invalid_argument) << keyword;
    }
    EXPECT_THROW(write_with({std::string(80, 'k'), "text"}), std::invalid_argument);
    EXPECT_NO_THROW(write_with({std::string(79, 'k'), "text"}));
    std::filesystem::remove(file("a.png"));
    EXPECT_THROW(write_with({"key", std::string("a\0b", 3)}), std::invalid_argument);
    EXPECT_THROW(write_png(file("a.png"), image, {.bits = 0}), std::invalid_argument);
    EXPECT_THROW(write_png(file("a.png"), image, {.bits = 17}), std::invalid_argument);
    EXPECT_THROW(write_png(file("a.png"), image, {.bits = 1}), std::invalid_argument);
    EXPECT_THROW(write_png(file("a.png"), image, {.level = -1}), std::invalid_argument);
    EXPECT_THROW(write_png(file("a.png"), image, {.level = 10}), std::invalid_argument);
    EXPECT_THROW(write_png(file("a.png"), Image<CodeRGB>()), std::invalid_argument);
    EXPECT_THAT(files(), IsEmpty());
}

TEST_F(PngFile, MissingFolderIsAnIoError) {
    try {
        write_png(file("nowhere") / "a.png", random_image(2, 2));
        FAIL() << "no exception";
    } catch (const IoError& error) {
        EXPECT_EQ(error.path(), file("nowhere") / "a.png");
        EXPECT_THAT(error.reason(), HasSubstr("No such file or directory"));
    }
}

/// Exit status of a child that writes with a limit on the size of files: 0 if it saw the right error.
int status_with_file_limit(const std::filesystem::path& path, const Image<CodeRGB>& image, rlim_t limit_bytes) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{limit_bytes, limit_bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        int status = 1;
        try {
            write_png(path, image);
        } catch (const IoError& error) {
            const bool right = error.path() == path && error.reason().find("File too large") != std::string::npos;
            status = right ? 0 : 2;
        }
        ::_exit(status);
    }
    int status = -1;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// The limit strikes in the first buffer, in the middle, and in the last bytes, which are written on closing.
TEST_F(PngFile, FullDiskLeavesWhatWasThere) {
    const Image<CodeRGB> image = random_image(200, 200);
    write_png(file("whole.png"), image);
    const auto size = std::filesystem::file_size(file("whole.png"));
    write_text(file("old.png"), "old");
    for (const auto limit : {std::uintmax_t{1}, std::uintmax_t{5000}, size / 2, size - 1}) {
        EXPECT_EQ(status_with_file_limit(file("new.png"), image, limit), 0) << limit;
        EXPECT_EQ(status_with_file_limit(file("old.png"), image, limit), 0) << limit;
    }
    EXPECT_EQ(read_text(file("old.png")), "old");
    EXPECT_THAT(files(), ElementsAre("old.png", "whole.png"));
}

TEST_F(PngFile, ReplacesAnOldFile) {
    write_text(file("a.png"), "old");
    const Image<CodeRGB> image = random_image(3, 3);
    write_png(file("a.png"), image);
    EXPECT_EQ(read_back(file("a.png")).image, image);
    EXPECT_THAT(files(), ElementsAre("a.png"));
}

}  // namespace
}  // namespace emulsion
