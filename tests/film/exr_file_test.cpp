#include "film/exr_file.h"

#include <array>
#include <bit>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "core/error.h"
#include "core/random.h"

namespace emulsion {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::ThrowsMessage;

class ExrFile : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "emulsion-exr-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }
    void TearDown() override { fs::remove_all(folder_); }

    [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] std::size_t files_in_folder() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

  private:
    fs::path folder_;
};

/// Values of every size, some negative, with the largest half at hand.
Image<XYZ> picture(int width, int height, float scale = 1.0f) {
    Image<XYZ> image(width, height);
    Pcg32 random(7);
    for (XYZ& pixel : image.pixels()) {
        const float size = scale * std::ldexp(1.0f, static_cast<int>(random.next() % 24u) - 12);
        pixel = {size * random.next_float(), size * random.next_float(), size * (random.next_float() - 0.1f)};
    }
    return image;
}

FilmMetadata metadata() {
    return {
        64, std::uint64_t{1} << 40u, 3, 0xfedcba9876543210u, "0.1.0 (test)", "emulsion render \"a b.pbrt\" --spp 64"};
}

const std::vector<ExrOptions> kAllOptions = [] {
    std::vector<ExrOptions> all;
    for (const ExrColor color : {ExrColor::xyz, ExrColor::rec709}) {
        for (const PixelType type : {PixelType::float32, PixelType::half}) {
            for (const ExrCompression compression : {ExrCompression::none, ExrCompression::zip}) {
                all.push_back({color, type, compression});
            }
        }
    }
    return all;
}();

bool same_bits(const Image<XYZ>& a, const Image<XYZ>& b) {
    return a.width() == b.width() && a.height() == b.height() &&
           std::memcmp(a.pixels().data(), b.pixels().data(), a.pixels().size_bytes()) == 0;
}

std::string contents(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A new file each time: some file systems flush one that is overwritten to disk, and these tests write thousands.
void write_bytes(const fs::path& path, const std::string& bytes) {
    fs::remove(path);
    std::ofstream(path, std::ios::binary) << bytes;
}

/// IoError of one line that starts with the path.
template <class... Matchers>
auto throws_io_error(const fs::path& path, const Matchers&... matchers) {
    return ThrowsMessage<IoError>(AllOf(testing::StartsWith(path.string() + ": "), Not(HasSubstr("\n")), matchers...));
}

// --- What is written

TEST_F(ExrFile, ReadsBackWhatAsStoredSays) {
    Image<XYZ> image = picture(37, 131);
    image(0, 0) = {-0.0f, 1e-40f, 65504.0f};
    image(1, 0) = {1e-9f, 65519.0f, -1e5f};
    image(2, 0) = {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 3e38f};
    for (const ExrOptions& options : kAllOptions) {
        write_exr(file("a.exr"), image, metadata(), options);
        const FilmImage read = read_exr(file("a.exr"));
        EXPECT_TRUE(same_bits(read.xyz, as_stored(image, options)));
        EXPECT_EQ(read.metadata, metadata());
        EXPECT_EQ(read.data_window, (PixelBounds{0, 0, 37, 131}));
        EXPECT_THAT(read.notes, IsEmpty());
        EXPECT_EQ(files_in_folder(), 1u);
    }
}

TEST_F(ExrFile, FloatXyzIsStoredAsItIs) {
    const Image<XYZ> image = picture(9, 5);
    EXPECT_TRUE(same_bits(as_stored(image, {}), image));
}

TEST_F(ExrFile, RgbAndHalfKeepTheirPrecision) {
    const Image<XYZ> image = picture(64, 64);
    const Image<XYZ> rgb = as_stored(image, {ExrColor::rec709});
    const Image<XYZ> half = as_stored(image, {ExrColor::xyz, PixelType::half});
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const XYZ expected = image.pixels()[i];
        const float size = expected.x + expected.y + std::abs(expected.z);
        EXPECT_NEAR(rgb.pixels()[i].x, expected.x, 1e-6f * size);
        EXPECT_NEAR(rgb.pixels()[i].y, expected.y, 1e-6f * size);
        EXPECT_NEAR(rgb.pixels()[i].z, expected.z, 1e-6f * size);
        EXPECT_NEAR(half.pixels()[i].y, expected.y, 0x1p-11f * expected.y + 0x1p-25f);
    }
}

TEST_F(ExrFile, CountsWhatItCannotHold) {
    Image<XYZ> image(2, 1);
    image(0, 0) = {65504.0f, 65505.0f, -1e6f};
    image(1, 0) = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 0.0f};
    const ExrOptions half{ExrColor::xyz, PixelType::half};
    EXPECT_EQ(write_exr(file("a.exr"), image, {}, half), (ExrWriteResult{2, 2}));
    EXPECT_EQ(read_exr(file("a.exr")).xyz(0, 0), (XYZ{65504.0f, 65504.0f, -65504.0f}));
    EXPECT_EQ(write_exr(file("b.exr"), image, {}), (ExrWriteResult{0, 2}));

    image(1, 0) = {3e38f, 0.0f, 0.0f};  // red of Rec. 709 is 3.24 times that
    EXPECT_EQ(write_exr(file("c.exr"), image, {}, {ExrColor::rec709}), (ExrWriteResult{1, 0}));
}

TEST_F(ExrFile, HeaderSaysWhatTheNumbersAre) {
    write_exr(file("xyz.exr"), picture(4, 4), metadata());
    const Imf::InputFile xyz(file("xyz.exr").c_str());
    EXPECT_EQ(Imf::chromaticities(xyz.header()).red, Imath::V2f(1.0f, 0.0f));
    EXPECT_EQ(Imf::chromaticities(xyz.header()).green, Imath::V2f(0.0f, 1.0f));
    EXPECT_EQ(Imf::chromaticities(xyz.header()).blue, Imath::V2f(0.0f, 0.0f));
    EXPECT_EQ(Imf::whiteLuminance(xyz.header()), 1.0f);
    EXPECT_EQ(xyz.header().channels()["Y"].type, Imf::FLOAT);
    EXPECT_EQ(xyz.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(xyz.header().typedAttribute<Imf::StringAttribute>("emulsion.samplesPerPixel").value(), "64");
    EXPECT_EQ(xyz.header().typedAttribute<Imf::StringAttribute>("emulsion.commandLine").value(),
              metadata().command_line);

    write_exr(file("rgb.exr"), picture(4, 4), {}, {ExrColor::rec709, PixelType::half, ExrCompression::none});
    const Imf::InputFile rgb(file("rgb.exr").c_str());
    EXPECT_EQ(Imf::chromaticities(rgb.header()).red, Imath::V2f(0.64f, 0.33f));
    EXPECT_EQ(Imf::chromaticities(rgb.header()).white, Imath::V2f(0.3127f, 0.329f));
    EXPECT_EQ(rgb.header().channels()["G"].type, Imf::HALF);
    EXPECT_EQ(rgb.header().compression(), Imf::NO_COMPRESSION);
}

// D65 with Y = 1 is RGB (1, 1, 1), to any other reader of the file as well.
TEST_F(ExrFile, WhiteIsRgbOne) {
    Image<XYZ> image(1, 1);
    image(0, 0) = {0.3127f / 0.329f, 1.0f, (1.0f - 0.3127f - 0.329f) / 0.329f};
    write_exr(file("a.exr"), image, {}, {ExrColor::rec709});
    Imf::InputFile in(file("a.exr").c_str());
    std::array<float, 3> rgb{};
    Imf::FrameBuffer pixels;
    const std::array<const char*, 3> names = {"R", "G", "B"};
    for (std::size_t i = 0; i < 3; ++i) {
        pixels.insert(names[i], Imf::Slice(Imf::FLOAT, std::bit_cast<char*>(&rgb[i]), 4, 4));
    }
    in.setFrameBuffer(pixels);
    in.readPixels(0);
    for (const float value : rgb) EXPECT_NEAR(value, 1.0f, 1e-6f);
}

TEST_F(ExrFile, RefusesAnImageWithoutPixels) {
    EXPECT_THROW(write_exr(file("a.exr"), Image<XYZ>(), {}), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(as_stored(Image<XYZ>(), {})), std::invalid_argument);
    EXPECT_EQ(files_in_folder(), 0u);
}

// --- Files that cannot be written

TEST_F(ExrFile, WriteIntoAMissingFolderIsAnIoError) {
    const fs::path path = file("missing") / "a.exr";
    EXPECT_THAT([&] { write_exr(path, picture(2, 2), {}); }, throws_io_error(path));
}

TEST_F(ExrFile, WriteOverAFolderIsAnIoError) {
    fs::create_directory(file("folder.exr"));
    EXPECT_THAT([&] { write_exr(file("folder.exr"), picture(2, 2), {}); }, throws_io_error(file("folder.exr")));
}

/// In a process whose files may not grow past `limit` bytes: 0 if write_exr threw an IoError that names the reason.
[[noreturn]] void write_with_limit(const fs::path& path, const ExrOptions& options, std::uint64_t limit) {
    std::signal(SIGXFSZ, SIG_IGN);
    const ::rlimit limits{limit, limit};
    ::setrlimit(RLIMIT_FSIZE, &limits);
    int status = 1;
    try {
        write_exr(path, picture(64, 200), metadata(), options);
    } catch (const IoError& error) {
        const bool named = error.path() == path && error.reason().find("File too large") != std::string::npos;
        status = named ? 0 : 2;
    }
    std::_Exit(status);
}

// A disk that fills up at the header, in the middle, and at the last byte. That one is still in the stream's buffer
// when OpenEXR's destructor, which swallows errors, flushes it.
TEST_F(ExrFile, FullDiskLeavesTheOldFileAndNoPartOfTheNew) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    for (const ExrCompression compression : {ExrCompression::none, ExrCompression::zip}) {
        const ExrOptions options{ExrColor::xyz, PixelType::float32, compression};
        write_exr(file("whole.exr"), picture(64, 200), metadata(), options);
        const std::uint64_t size = fs::file_size(file("whole.exr"));
        for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{100}, size / 2, size - 1}) {
            write_bytes(file("old.exr"), "old");
            EXPECT_EXIT(write_with_limit(file("old.exr"), options, limit), testing::ExitedWithCode(0), "") << limit;
            EXPECT_EQ(contents(file("old.exr")), "old");
            EXPECT_EQ(files_in_folder(), 2u);
        }
        EXPECT_EXIT(write_with_limit(file("old.exr"), options, size), testing::ExitedWithCode(1), "")
            << "the limit that just suffices must not fail: then the limits above test nothing";
    }
}

// --- Files of others

struct ForeignFile {
    std::vector<std::string> channels = {"R", "G", "B"};
    Imf::PixelType type = Imf::FLOAT;
    Imath::Box2i window{{0, 0}, {4, 2}};
    Imf::Compression compression = Imf::PIZ_COMPRESSION;
};

/// Every channel of pixel i holds i + 1.
template <class Prepare>
void write_foreign(const fs::path& path, const ForeignFile& what, const Prepare& prepare) {
    Imf::Header header(what.window, what.window);
    header.compression() = what.compression;
    for (const std::string& name : what.channels) header.channels().insert(name, Imf::Channel(what.type));
    prepare(header);
    const int width = what.window.max.x - what.window.min.x + 1, height = what.window.max.y - what.window.min.y + 1;
    std::vector<float> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<unsigned> whole(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = static_cast<float>(i + 1);
        whole[i] = static_cast<unsigned>(i + 1);
    }
    const void* data = what.type == Imf::UINT ? static_cast<const void*>(whole.data()) : values.data();
    Imf::FrameBuffer pixels;
    for (const std::string& name : what.channels) pixels.insert(name, Imf::Slice::Make(what.type, data, what.window));
    Imf::OutputFile out(path.c_str(), header);
    out.setFrameBuffer(pixels);
    out.writePixels(height);
}
void write_foreign(const fs::path& path, const ForeignFile& what) {
    write_foreign(path, what, [](Imf::Header&) {});
}

TEST_F(ExrFile, ForeignRgbWithoutChromaticitiesIsTakenAsRec709AndSaid) {
    write_foreign(file("a.exr"), {});
    const FilmImage read = read_exr(file("a.exr"));
    // Y of an equal R, G and B is that number in every space whose white has Y = 1.
    EXPECT_NEAR(read.xyz(4, 2).y, 15.0f, 1e-5f);
    EXPECT_NEAR(read.xyz(0, 0).x, 0.3127f / 0.329f, 1e-6f);
    EXPECT_THAT(read.notes, ElementsAre(HasSubstr("chromaticities"), HasSubstr("whiteLuminance")));
    EXPECT_EQ(read.metadata, FilmMetadata{});
}

TEST_F(ExrFile, ForeignChromaticitiesAndWhiteLuminanceCount) {
    write_foreign(file("a.exr"), {}, [](Imf::Header& header) {
        // The primaries of XYZ under the names R G B, as some programs write it.
        Imf::addChromaticities(header, {{1, 0}, {0, 1}, {0, 0}, {1.0f / 3.0f, 1.0f / 3.0f}});
        Imf::addWhiteLuminance(header, 80.0f);
    });
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_NEAR(read.xyz(1, 0).x, 160.0f, 1e-4f);
    EXPECT_NEAR(read.xyz(1, 0).y, 160.0f, 1e-4f);
    EXPECT_NEAR(read.xyz(1, 0).z, 160.0f, 1e-4f);
    EXPECT_THAT(read.notes, IsEmpty());
}

TEST_F(ExrFile, DegenerateChromaticitiesAreRefused) {
    write_foreign(file("a.exr"), {}, [](Imf::Header& header) {
        Imf::addChromaticities(header, {{0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}});
    });
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("a.exr"))); }, throws_io_error(file("a.exr")));
}

TEST_F(ExrFile, DataWindowMayLieAnywhere) {
    ForeignFile what;
    what.window = {{-7, 100}, {-3, 102}};
    write_foreign(file("a.exr"), what);
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_EQ(read.data_window, (PixelBounds{-7, 100, -2, 103}));
    EXPECT_NEAR(read.xyz(4, 2).y, 15.0f, 1e-5f);
}

TEST_F(ExrFile, OtherChannelsAreLeftOutAndSaid) {
    ForeignFile what;
    what.channels = {"A", "B", "G", "R", "X", "Y", "Z"};
    write_foreign(file("a.exr"), what);
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_EQ(read.xyz(1, 0), (XYZ{2.0f, 2.0f, 2.0f})) << "X Y Z come before R G B";
    EXPECT_THAT(read.notes, ElementsAre(HasSubstr("channel A"), HasSubstr("channel B"), HasSubstr("channel G"),
                                        HasSubstr("channel R"), HasSubstr("whiteLuminance")));
}

TEST_F(ExrFile, OtherKindsOfChannelsAreRefused) {
    ForeignFile grey;
    grey.channels = {"Y", "RY", "BY"};
    write_foreign(file("grey.exr"), grey);
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("grey.exr"))); },
                throws_io_error(file("grey.exr"), HasSubstr("BY RY Y, expected X Y Z or R G B")));
    ForeignFile whole;
    whole.type = Imf::UINT;
    write_foreign(file("whole.exr"), whole);
    EXPECT_THAT([&] { static_cast<void>(read_exr(file("whole.exr"))); },
                throws_io_error(file("whole.exr"), HasSubstr("channel R holds whole numbers")));
}

TEST_F(ExrFile, TiledFilesAreRead) {
    Imf::Header header(5, 3);
    for (const char* name : {"R", "G", "B"}) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    header.setTileDescription(Imf::TileDescription(64, 64, Imf::ONE_LEVEL));
    const std::vector<float> values(15, 2.0f);
    {
        Imf::FrameBuffer pixels;
        for (const char* name : {"R", "G", "B"}) {
            pixels.insert(name, Imf::Slice::Make(Imf::FLOAT, values.data(), header.dataWindow()));
        }
        Imf::TiledOutputFile out(file("a.exr").c_str(), header);
        out.setFrameBuffer(pixels);
        out.writeTile(0, 0);
    }
    EXPECT_NEAR(read_exr(file("a.exr")).xyz(3, 1).y, 2.0f, 1e-6f);
}

TEST_F(ExrFile, MetadataThatIsNoNumberIsLeftOutAndSaid) {
    write_foreign(file("a.exr"), {}, [](Imf::Header& header) {
        header.insert("emulsion.seed", Imf::StringAttribute("12x"));
        header.insert("emulsion.samplesPerPixel", Imf::StringAttribute("99999999999999999999"));
        header.insert("emulsion.rendererVersion", Imf::StringAttribute("7"));
    });
    const FilmImage read = read_exr(file("a.exr"));
    EXPECT_EQ(read.metadata.seed, 0u);
    EXPECT_EQ(read.metadata.renderer_version, "7");
    EXPECT_THAT(read.notes, testing::Contains(HasSubstr("emulsion.seed is \"12x\"")));
    EXPECT_THAT(read.notes, testing::Contains(HasSubstr("emulsion.samplesPerPixel")));
}

// --- Files that are no film files

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
        const std::string whole = contents(file("whole.exr"));
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
        const std::string whole = contents(file("whole.exr"));
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
        const std::string whole = contents(file("whole.exr"));
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
