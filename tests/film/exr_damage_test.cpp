#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include "core/error.h"
#include "exr_fixture.h"
#include "film/exr_file.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(ExrFile, MissingFoldersAndOtherFilesAreIoErrors) {
    const auto expect_refused = [&](const fs::path& path, const char* reason) {
        EXPECT_THAT([&] { static_cast<void>(read_exr(path)); }, throws_io_error(path, HasSubstr(reason)));
    };
    expect_refused(file("missing.exr"), "No such file");
    fs::create_directory(file("folder.exr"));
    expect_refused(file("folder.exr"), "is a folder");
    write_bytes(file("empty.exr"), "");
    expect_refused(file("empty.exr"), "is empty");
    write_bytes(file("short.exr"), "abc");
    expect_refused(file("short.exr"), "is not an EXR file");
    write_bytes(file("text.exr"), "This is the text of a letter to nobody in particular.\n");
    expect_refused(file("text.exr"), "is not an EXR file");
    expect_refused("/dev/zero", "is not a regular file");
}

TEST_F(ExrFile, TruncatedFilesAreRefusedWhereverTheyEnd) {
    for (const ExrOptions& options : kAllOptions) {
        write_exr(file("whole.exr"), picture(20, 40), metadata(), options);
        const std::string whole = read_text(file("whole.exr"));
        for (std::size_t size = 0; size < whole.size(); size += size + 30 < whole.size() ? 17 : 1) {
            write_bytes(file("cut.exr"), whole.substr(0, size));
            ASSERT_THAT([&] { static_cast<void>(read_exr(file("cut.exr"))); }, throws_io_error(file("cut.exr")))
                << size << " of " << whole.size() << " bytes";
        }
    }
}

TEST_F(ExrFile, UnfinishedFilesAreRefused) {
    Imf::Header header(5, 40);
    for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const std::vector<float> values(200, 1.0f);
    {
        Imf::FrameBuffer pixels;
        for (const char* name : {"R", "G", "B"}) {
            pixels.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
        }
        Imf::OutputFile out(file("a.exr").c_str(), header);
        out.setFrameBuffer(pixels);
        out.writePixels(20);
    }
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("a.exr"))); },
                throws_io_error(file("a.exr"), HasSubstr("incomplete")));
}

// Every bit of the header and of the table of chunks in one kind of file, and one in a few of the rest and of the other
// kinds: an IoError or a picture, no crash, and no memory that such a file could not fill.
TEST_F(ExrFile, FlippedBitsNeverCrash) {
    for (const ExrOptions& options : kAllOptions) {
        write_exr(file("whole.exr"), picture(20, 40), metadata(), options);
        const std::string whole = read_text(file("whole.exr"));
        int refused = 0;
        const std::size_t step = options == kAllOptions.back() ? 1 : 23;
        for (std::size_t bit = 0; bit < 8 * whole.size(); bit += bit < 8 * std::size_t{1000} ? step : 211) {
            std::string damaged = whole;
            damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
            write_bytes(file("bad.exr"), damaged);
            try {
                const FilmImage read = read_exr(file("bad.exr"));
                ASSERT_LE(read.xyz.pixels().size(), std::size_t{1} << 22u);
            } catch (const IoError& error) {
                ++refused;
                ASSERT_EQ(error.path(), file("bad.exr"));
                ASSERT_THAT(std::string(error.what()), Not(HasSubstr("\n"))) << "bit " << bit;
            }
        }
        EXPECT_GT(refused, 50);
    }
}

/// The whole file with the four words of its data window replaced.
std::string with_window(std::string bytes, std::array<std::int32_t, 4> window) {
    const std::size_t name = bytes.find("dataWindow");
    std::memcpy(bytes.data() + name + std::strlen("dataWindow") + 1 + std::strlen("box2i") + 1 + 4, window.data(), 16);
    return bytes;
}

TEST_F(ExrFile, AbsurdDataWindowsAreRefusedBeforeAnyAllocation) {
    for (const ExrOptions& options : kAllOptions) {
        write_exr(file("whole.exr"), picture(20, 40), metadata(), options);
        const std::string whole = read_text(file("whole.exr"));
        constexpr std::int32_t kMax = std::numeric_limits<std::int32_t>::max();
        constexpr std::int32_t kMin = std::numeric_limits<std::int32_t>::min();
        const std::vector<std::array<std::int32_t, 4>> windows = {
            {0, 0, kMax, kMax},   {0, 0, kMax - 1, 0}, {0, 0, 0, kMax - 1}, {kMin, kMin, kMax, kMax},
            {0, 0, 99999, 99999}, {5, 0, 4, 3},        {0, 0, -1, -1},      {kMax, 0, kMin, 0}};
        for (const auto& window : windows) {
            write_bytes(file("bad.exr"), with_window(whole, window));
            EXPECT_THAT([&] { static_cast<void>(read_exr(file("bad.exr"))); },
                        throws_io_error(file("bad.exr"), HasSubstr("pixels")));
        }
    }
}

TEST_F(ExrFile, HighlyCompressedPicturesAreNotTakenForAbsurd) {
    Image<XYZ> black(2000, 2000);
    write_exr(file("a.exr"), black, {});
    EXPECT_LT(fs::file_size(file("a.exr")), 100000u);
    EXPECT_EQ(read_exr(file("a.exr")).xyz, black);
    for (const Imf::Compression compression : {Imf::RLE_COMPRESSION, Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION,
                                               Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        Imf::Header header(2000, 500);
        header.compression() = compression;
        for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::HALF));
        {
            const std::vector<half> zeros(2000 * 500);
            Imf::FrameBuffer pixels;
            for (const char* name : {"R", "G", "B"}) {
                pixels.insert(name, Imf::Slice::Make(Imf::HALF, zeros.data(), header.dataWindow()));
            }
            Imf::OutputFile out(file("b.exr").c_str(), header);
            out.setFrameBuffer(pixels);
            out.writePixels(500);
        }
        EXPECT_EQ(read_exr(file("b.exr")).xyz(1999, 499), XYZ{}) << compression;
    }
}

}  // namespace
}  // namespace emulsion
