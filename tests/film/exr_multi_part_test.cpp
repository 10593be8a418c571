// Files of several parts, of which the first with a picture counts.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include "core/named_value.h"
#include "core/random.h"
#include "exr_fixture.h"
#include "film/exr_file.h"
#include "film/exr_parts.h"

namespace emulsion {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr int kWidth = 20, kHeight = 40;

Imf::Header header_of(const char* name, const ExrCompression& compression, const std::vector<std::string>& channels,
                      Imf::PixelType type) {
    Imf::Header header(kWidth, kHeight);
    header.setName(name);
    set_compression(header, compression);
    for (const std::string& channel : channels) header.channels().insert(channel, Imf::Channel(type));
    return header;
}

/// "sums" with whole numbers, "picture" with R G B, "again" with X Y Z, each value its place in the part.
void write_parts(const fs::path& path, const ExrCompression& compression) {
    std::vector<std::uint32_t> whole(kWidth * kHeight);
    std::vector<float> values(kWidth * kHeight);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        whole[i] = static_cast<std::uint32_t>(i);
        values[i] = static_cast<float>(i);
    }
    std::vector<ExrPart> parts;
    const auto add = [&](const char* name, const std::vector<std::string>& channels, Imf::PixelType type,
                         const auto& numbers, int rows_at_once) {
        const Imf::Header header = header_of(name, compression, channels, type);
        parts.push_back({header, rows_at_once, [=, &numbers](int first, int count) {
                             Imf::FrameBuffer rows;
                             for (const std::string& channel : channels) {
                                 const auto* row = &numbers[static_cast<std::size_t>(first) * kWidth];
                                 rows.insert(channel, exr_slice(type, row, sizeof(*row), header, first, count));
                             }
                             return rows;
                         }});
    };
    add("sums", {"limb0", "limb1"}, Imf::UINT, whole, 7);
    add("picture", {"R", "G", "B"}, Imf::FLOAT, values, kHeight);
    add("again", {"X", "Y", "Z"}, Imf::FLOAT, values, 16);
    for (ExrPart& part : parts) Imf::addChromaticities(part.header, Imf::Chromaticities());
    write_exr_parts(path, parts, 2);
}

TEST_F(ExrFile, OfSeveralPartsTheFirstPictureIsRead) {
    for (const ExrCompression& compression : {ExrCompression(NoCompression{}), ExrCompression(ZipCompression{})}) {
        write_parts(file("a.exr"), compression);
        EXPECT_EQ(Imf::MultiPartInputFile(file("a.exr").c_str()).parts(), 3);
        const FilmImage read = read_exr(file("a.exr"));
        EXPECT_NEAR(read.xyz(3, 5).y, 103.0f, 1e-4f);
        EXPECT_NEAR(read.xyz(19, 39).y, 799.0f, 1e-3f);
        EXPECT_THAT(read.notes, ElementsAre("part \"sums\" was left out", "part \"again\" was left out",
                                            HasSubstr("whiteLuminance")));
        EXPECT_EQ(files_in_folder(), 1u);
    }
}

TEST_F(ExrFile, OnePartMakesAPlainFile) {
    write_exr(file("a.exr"), picture(4, 4), {});
    constexpr std::size_t kFlags = 5;
    EXPECT_EQ(read_text(file("a.exr"))[kFlags], '\0') << "a flag of the format, as that for several parts";
}

TEST_F(ExrFile, PartsWithoutAPictureAreRefused) {
    std::vector<Imf::Header> headers = {header_of("a", NoCompression{}, {"Y"}, Imf::FLOAT),
                                        header_of("b", NoCompression{}, {"R", "G"}, Imf::FLOAT)};
    for (Imf::Header& header : headers) header.setType(Imf::SCANLINEIMAGE);
    { const Imf::MultiPartOutputFile out(file("a.exr").c_str(), headers.data(), 2); }
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("a.exr"))); },
                throws_io_error(file("a.exr"), HasSubstr("too many for")));
    const std::string header = read_text(file("a.exr"));
    write_bytes(file("b.exr"), header + std::string(20000, '\0'));
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("b.exr"))); },
                throws_io_error(file("b.exr"), HasSubstr("has the channels Y G R, expected X Y Z or R G B")));
}

TEST_F(ExrFile, DeepPartsAreRefused) {
    std::vector<Imf::Header> headers = {header_of("a", ZipsCompression{}, {"X", "Y", "Z"}, Imf::FLOAT),
                                        header_of("b", ZipsCompression{}, {"Z"}, Imf::FLOAT)};
    headers[0].setType(Imf::SCANLINEIMAGE);
    headers[1].setType(Imf::DEEPSCANLINE);
    { const Imf::MultiPartOutputFile out(file("a.exr").c_str(), headers.data(), 2); }
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("a.exr"))); }, throws_io_error(file("a.exr"), HasSubstr("deep")));
    // Without the flag for it in the version, the part's own type tells.
    std::string bytes = read_text(file("a.exr"));
    constexpr std::size_t kFlags = 5;
    bytes[kFlags] = static_cast<char>(bytes[kFlags] & ~0x08);
    write_bytes(file("b.exr"), bytes);
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("b.exr"))); }, throws_io_error(file("b.exr"), HasSubstr("deep")));
}

TEST_F(ExrFile, TruncatedPartsAreRefusedWhereverTheyEnd) {
    for (const ExrCompression& compression : {ExrCompression(NoCompression{}), ExrCompression(ZipCompression{})}) {
        write_parts(file("whole.exr"), compression);
        const std::string whole = read_text(file("whole.exr"));
        // Behind the picture, the last part's pixels are nothing to a reader of the picture.
        const std::size_t end_of_picture = whole.size() - (compression.index() == 0 ? kWidth * kHeight * 12 : 100);
        for (std::size_t size = 0; size < whole.size(); size += 23) {
            write_bytes(file("cut.exr"), whole.substr(0, size));
            try {
                const FilmImage read = read_exr(file("cut.exr"));
                ASSERT_GT(size, end_of_picture / 2);
                ASSERT_NEAR(read.xyz(19, 39).y, 799.0f, 1e-3f) << size << " of " << whole.size() << " bytes";
                ASSERT_NEAR(read.xyz(0, 20).y, 400.0f, 1e-3f) << size << " of " << whole.size() << " bytes";
            } catch (const IoError& error) {
                ASSERT_EQ(error.path(), file("cut.exr"));
            }
        }
    }
}

/// The bytes with the value of the last attribute of this name and type replaced by these words.
std::string with_attribute(std::string bytes, const std::string& name, const std::string& type,
                           const std::vector<std::int32_t>& words) {
    const std::string before = name + '\0' + type + '\0';
    const std::size_t at = bytes.rfind(before);
    EXPECT_NE(at, std::string::npos) << name;
    if (at != std::string::npos) std::memcpy(&bytes[at + before.size() + 4], words.data(), 4 * words.size());
    return bytes;
}

TEST_F(ExrFile, AbsurdSizesOfAnyPartAreRefusedBeforeAnyAllocation) {
    write_parts(file("whole.exr"), ZipCompression{});
    const std::string whole = read_text(file("whole.exr"));
    const auto refused = [&](const std::string& bytes) {
        write_bytes(file("bad.exr"), bytes);
        EXPECT_THAT([&] { static_cast<void>(read_exr(file("bad.exr"))); },
                    throws_io_error(file("bad.exr"), HasSubstr("pixels")));
    };
    refused(with_attribute(whole, "dataWindow", "box2i", {0, 0, 99999, 99999}));
    refused(with_attribute(whole, "dataWindow", "box2i", {0, 0, -1, -1}));
    refused(with_attribute(whole, "chunkCount", "int", {1 << 30}));
    refused(with_attribute(whole, "dataWindow", "box2i", {0, 0, 0, (1 << 30) - 2}));
}

/// Random bytes in the headers and the tables of chunks, and anywhere: an IoError or a picture of a size that the file
/// can hold, no crash. Returns how many were refused.
int refused_of(int trials, const std::string& whole, const fs::path& bad, Pcg32& random) {
    int refused = 0;
    for (int trial = 0; trial < trials; ++trial) {
        std::string damaged = whole;
        const std::size_t end = std::min(trial % 2 == 0 ? std::size_t{2500} : whole.size(), whole.size());
        for (int i = 0; i <= trial % 3; ++i) damaged[random.next() % end] = static_cast<char>(random.next() & 0xffu);
        write_bytes(bad, damaged);
        try {
            const FilmImage read = read_exr(bad);
            EXPECT_LE(read.xyz.pixels().size(), std::size_t{1} << 24u);
        } catch (const IoError& error) {
            ++refused;
            EXPECT_EQ(error.path(), bad);
        }
    }
    return refused;
}

TEST_F(ExrFile, RandomDamageToPartsAndLayersNeverCrashes) {
    Pcg32 random(5);
    for_each_alternative<ExrCompression>([&](const auto& compression) {
        SCOPED_TRACE(compression.kName);
        write_parts(file("parts.exr"), compression);
        EXPECT_GT(refused_of(400, read_text(file("parts.exr")), file("bad.exr"), random), 50);
        for (const PixelType type : {PixelType::float32, PixelType::half}) {
            write_exr(file("layers.exr"), film_picture(), metadata(), {.pixel_type = type, .compression = compression});
            EXPECT_GT(refused_of(200, read_text(file("layers.exr")), file("bad.exr"), random), 20);
        }
    });
}

}  // namespace
}  // namespace emulsion
