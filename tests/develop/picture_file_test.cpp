// Pictures of all formats, whole and damaged.

#include "develop/picture_file.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/random.h"
#include "display/png_file.h"
#include "film/exr_file.h"
#include "film/pfm_file.h"
#include "film/radiance_file.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;

struct SmallFile {
    std::string name, bytes;
};

/// One of each format and kind of packing, of 9 x 3 pixels.
std::vector<SmallFile> small_files() {
    const TemporaryFolder folder;
    Image<XYZ> xyz(9, 3);
    Image<CodeRGB> codes(9, 3);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 9; ++x) {
            xyz(x, y) = {0.9f + static_cast<float>(x), 1.0f + static_cast<float>(x * y), 1.1f};
            codes(x, y) = {static_cast<std::uint16_t>(20 * x), static_cast<std::uint16_t>(90 * y), 7};
        }
    }
    std::vector<SmallFile> files;
    const auto add = [&](const std::string& name) { files.push_back({name, read_text(folder.file(name))}); };
    (void)write_exr(folder.file("a.exr"), xyz, {}, {.compression = NoCompression{}});
    write_pfm(folder.file("a.pfm"), xyz);
    write_radiance(folder.file("a.hdr"), xyz);
    write_png(folder.file("a.png"), codes);
    write_png(folder.file("stored.png"), codes, {.level = 0});
    write_png(folder.file("deep.png"), codes, {.bits = 16});
    for (const char* name : {"a.exr", "a.pfm", "a.hdr", "a.png", "stored.png", "deep.png"}) add(name);
    files.push_back({"grey.pfm", "Pf\n9 3\n1.0\n" + std::string(9 * 3 * 4, '\x3f')});
    const std::string pixel = "\x80\x40\x20\x81";
    std::string lines;
    for (int y = 0; y < 3; ++y) lines += pixel + "\1\1\1\3" + pixel + pixel + "\1\1\1\3";
    files.push_back(
        {"old.hdr", "#?RADIANCE\nEXPOSURE=2\nPRIMARIES=.64 .33 .3 .6 .15 .06 .33 .33\n\n-Y 3 +X 9\n" + lines});
    return files;
}

/// Whether it is a picture; false for an IoError that names the file. Anything else goes on to the test.
bool reads(const TemporaryFolder& folder, const std::string& bytes) {
    const std::string path = folder.file("picture");
    write_text(path, bytes);
    try {
        const ScenePicture picture = read_picture(path, 1);
        EXPECT_GE(picture.xyz.width(), 1);
        return true;
    } catch (const IoError& error) {
        EXPECT_EQ(error.path(), path);
        EXPECT_FALSE(error.reason().empty());
        EXPECT_EQ(error.reason().find('\n'), std::string::npos) << error.reason();
        return false;
    }
}

TEST(PictureFile, IsReadByItsContentsUnderAnyName) {
    const TemporaryFolder folder;
    for (const SmallFile& file : small_files()) {
        EXPECT_TRUE(reads(folder, file.bytes)) << file.name;
        const ScenePicture picture = read_picture(folder.file("picture"), 0);
        EXPECT_EQ(picture.xyz.width(), 9) << file.name;
        EXPECT_EQ(picture.xyz.height(), 3) << file.name;
    }
}

TEST(PictureFile, LayersWindowAndHeaderAreReadIfWanted) {
    const TemporaryFolder folder;
    const std::string path = folder.file("a.exr");
    FilmPicture picture;
    picture.xyz = Image<XYZ>(3, 2);
    picture.floats.push_back({"depth.Z", Image<float>(3, 2)});
    picture.data_window = {1, 1, 4, 3};
    picture.width_px = 8;
    picture.height_px = 6;
    (void)write_exr(path, picture, {.seed = 4, .renderer_version = "test"});
    const FilmImage read = read_picture_and_layers(path, 1);
    EXPECT_EQ(static_cast<const FilmPicture&>(read), picture);
    EXPECT_EQ(read.metadata.seed, 4U);

    for (const SmallFile& file : small_files()) {
        if (file.name.ends_with(".exr")) continue;
        write_text(path, file.bytes);
        const FilmImage other = read_picture_and_layers(path, 1);
        EXPECT_EQ(other.data_window, (PixelBounds{0, 0, 9, 3})) << file.name;
        EXPECT_EQ(other.width_px, 9);
        EXPECT_EQ(other.height_px, 3);
        EXPECT_EQ(other.xyz, read_picture(path, 1).xyz);
    }
}

TEST(PictureFile, TruncatedAnywhereIsAnError) {
    const TemporaryFolder folder;
    for (const SmallFile& file : small_files()) {
        for (std::size_t size = 0; size < file.bytes.size(); ++size) {
            ASSERT_FALSE(reads(folder, file.bytes.substr(0, size))) << file.name << " of " << size << " bytes";
        }
    }
}

// A flipped bit may well be another picture. It is no crash, no hang, and takes no memory that the file could not fill.
TEST(PictureFile, AFlippedBitIsAnErrorOrAPicture) {
    const TemporaryFolder folder;
    for (const SmallFile& file : small_files()) {
        for (std::size_t bit = 0; bit < 8 * file.bytes.size(); ++bit) {
            if (bit % (file.name == "a.exr" ? 29 : 5) != 0) continue;  // EXR has its own test, of all
            std::string damaged = file.bytes;
            damaged[bit / 8] = static_cast<char>(static_cast<unsigned char>(damaged[bit / 8]) ^ (1u << bit % 8));
            ASSERT_NO_THROW((void)reads(folder, damaged)) << file.name << ", bit " << bit;
        }
    }
}

TEST(PictureFile, BytesAtRandomAreAnErrorOrAPicture) {
    const TemporaryFolder folder;
    Pcg32 random(91);
    for (const SmallFile& file : small_files()) {
        for (int round = 0; round < 200; ++round) {
            std::string damaged = file.bytes;
            for (int i = 0; i < 4; ++i) damaged[random.next() % damaged.size()] = static_cast<char>(random.next());
            ASSERT_NO_THROW((void)reads(folder, damaged)) << file.name << ", round " << round;
        }
    }
}

TEST(PictureFile, OtherFilesAreNamed) {
    const TemporaryFolder folder;
    write_text(folder.file("a.jpg"), "\xff\xd8\xff\xe0 and so on");
    EXPECT_THAT([&] { (void)read_picture(folder.file("a.jpg"), 0); },
                testing::ThrowsMessage<IoError>(AllOf(HasSubstr("a.jpg: begins with \"????\""), HasSubstr("OpenEXR"),
                                                      HasSubstr("Radiance"), HasSubstr("PFM"), HasSubstr("PNG"))));
    EXPECT_THROW((void)read_picture(folder.file("none.exr"), 0), IoError);
    EXPECT_THAT([&] { (void)read_picture(folder.path(), 0); },
                testing::ThrowsMessage<IoError>(HasSubstr("is a folder, expected an OpenEXR, Radiance")));
    EXPECT_THAT([&] { (void)read_picture("/dev/null", 0); },
                testing::ThrowsMessage<IoError>(HasSubstr("is not a regular file, expected an OpenEXR, Radiance")));
    write_text(folder.file("empty"), "");
    EXPECT_THAT([&] { (void)read_picture(folder.file("empty"), 0); },
                testing::ThrowsMessage<IoError>(HasSubstr("is empty, expected an OpenEXR, Radiance")));
}

}  // namespace
}  // namespace emulsion
