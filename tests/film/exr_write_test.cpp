#include <array>
#include <bit>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <sys/resource.h>

#include "core/error.h"
#include "exr_fixture.h"
#include "film/exr_file.h"

namespace emulsion {
namespace {

using testing::IsEmpty;

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
    const Image<XYZ> rgb = as_stored(image, {.space = "sRGB"});
    const Image<XYZ> half = as_stored(image, {.pixel_type = PixelType::half});
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
    Image<XYZ> image(3, 1);
    image(0, 0) = {65504.0f, 65505.0f, -1e6f};
    image(1, 0) = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 0.0f};
    // Half has 2^-24 at least: half of that is a tie, which goes to 0, and a subnormal number is no loss.
    image(2, 0) = {0x1p-25f, -0x1p-30f, 0x1.8p-24f};
    const ExrOptions half{.pixel_type = PixelType::half};
    EXPECT_EQ(write_exr(file("a.exr"), image, {}, half), (ExrWriteResult{.too_high_count = 1,
                                                                         .too_low_count = 1,
                                                                         .vanished_positive_count = 1,
                                                                         .vanished_negative_count = 1,
                                                                         .non_finite_count = 2}));
    const Image<XYZ> read = read_exr(file("a.exr")).xyz;
    EXPECT_EQ(read(0, 0), (XYZ{65504.0f, 65504.0f, -65504.0f}));
    EXPECT_EQ(read(2, 0), (XYZ{0.0f, 0.0f, 0x1p-23f}));
    EXPECT_TRUE(std::signbit(read(2, 0).y));
    EXPECT_EQ(write_exr(file("b.exr"), image, {}), (ExrWriteResult{.non_finite_count = 2}));

    image(1, 0) = image(2, 0) = {};
    image(0, 0) = {3e38f, 0.0f, 0.0f};  // red of sRGB is 3.24 times that, blue 0.056 times, and green -0.97 times
    EXPECT_EQ(write_exr(file("c.exr"), image, {}, {.space = "sRGB"}), (ExrWriteResult{.too_high_count = 1}));
    image(0, 0) = {-3e38f, 0.0f, 0.0f};
    EXPECT_EQ(write_exr(file("d.exr"), image, {}, {.space = "sRGB"}), (ExrWriteResult{.too_low_count = 1}));
}

// The counts are sums over rows that many threads write.
TEST_F(ExrFile, CountsDoNotDependOnThreads) {
    const Image<XYZ> image = picture(300, 500, 100.0f);
    for (const char* space : {"XYZ", "ACEScg_AP1"}) {
        ExrOptions options{.space = space, .pixel_type = PixelType::half, .threads = 1};
        const ExrWriteResult one = write_exr(file("one.exr"), image, {}, options);
        EXPECT_GT(one.too_high_count, 1000);
        options.threads = 7;
        EXPECT_EQ(write_exr(file("seven.exr"), image, {}, options), one);
        EXPECT_EQ(read_text(file("seven.exr")), read_text(file("one.exr")));
        EXPECT_TRUE(same_bits(read_exr(file("one.exr"), {.threads = 1}).xyz, read_exr(file("one.exr")).xyz));
    }
}

TEST_F(ExrFile, HeaderSaysWhatTheNumbersAre) {
    write_exr(file("xyz.exr"), picture(4, 4), metadata());
    const Imf::InputFile xyz(file("xyz.exr").c_str());
    EXPECT_EQ(Imf::chromaticities(xyz.header()).red, Imath::V2f(1.0f, 0.0f));
    EXPECT_EQ(Imf::chromaticities(xyz.header()).green, Imath::V2f(0.0f, 1.0f));
    EXPECT_EQ(Imf::chromaticities(xyz.header()).blue, Imath::V2f(0.0f, 0.0f));
    EXPECT_EQ(Imf::whiteLuminance(xyz.header()), 1.0f);
    EXPECT_FALSE(Imf::hasAdoptedNeutral(xyz.header())) << "the white of the axes is nobody's neutral";
    EXPECT_EQ(xyz.header().channels()["Y"].type, Imf::FLOAT);
    EXPECT_EQ(xyz.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(xyz.header().typedAttribute<Imf::StringAttribute>("emulsion.samplesPerPixel").value(), "64");
    EXPECT_EQ(xyz.header().typedAttribute<Imf::StringAttribute>("emulsion.commandLine").value(),
              metadata().command_line);

    write_exr(file("rgb.exr"), picture(4, 4), {},
              {.space = "sRGB", .pixel_type = PixelType::half, .compression = NoCompression{}});
    const Imf::InputFile rgb(file("rgb.exr").c_str());
    EXPECT_EQ(Imf::chromaticities(rgb.header()).red, Imath::V2f(0.64f, 0.33f));
    EXPECT_EQ(Imf::chromaticities(rgb.header()).white, Imath::V2f(0.3127f, 0.329f));
    EXPECT_EQ(Imf::adoptedNeutral(rgb.header()), Imath::V2f(0.3127f, 0.329f));
    EXPECT_EQ(rgb.header().channels()["G"].type, Imf::HALF);
    EXPECT_EQ(rgb.header().compression(), Imf::NO_COMPRESSION);
}

// A film exposed four times as long: its numbers go into the file as they are, and the header says that 1 stands for
// 0.25 cd/m^2. Reading gives cd/m^2.
TEST_F(ExrFile, WhiteLuminanceIsWhatOneStandsFor) {
    const Image<XYZ> exposed = picture(9, 5);
    for (ExrOptions options : kAllOptions) {
        options.white_luminance_cdm2 = 0.25;
        write_exr(file("a.exr"), exposed, {}, options);
        EXPECT_EQ(Imf::whiteLuminance(Imf::InputFile(file("a.exr").c_str()).header()), 0.25f);
        const FilmImage read = read_exr(file("a.exr"));
        EXPECT_TRUE(same_bits(read.xyz, as_stored(exposed, options)));
        EXPECT_EQ(read.white_luminance_cdm2, 0.25);
        options.white_luminance_cdm2 = 1.0;
        const Image<XYZ> stored = as_stored(exposed, options);
        for (std::size_t i = 0; i < stored.pixels().size(); ++i) {
            EXPECT_EQ(read.xyz.pixels()[i].y, 0.25f * stored.pixels()[i].y);
        }
        // A number that single precision can't hold is rounded for the header, and for as_stored in the same way.
        options.white_luminance_cdm2 = 1.0 / 3.0;
        write_exr(file("a.exr"), exposed, {}, options);
        EXPECT_TRUE(same_bits(read_exr(file("a.exr")).xyz, as_stored(exposed, options)));
    }
}

TEST_F(ExrFile, RefusesAWhiteLuminanceOutOfRange) {
    for (const double bad : {0.0, -1.0, 1e31, 1e-31, HUGE_VAL, std::nan("")}) {
        const ExrOptions options{.white_luminance_cdm2 = bad};
        EXPECT_THROW(write_exr(file("a.exr"), picture(2, 2), {}, options), std::invalid_argument);
        EXPECT_THROW(static_cast<void>(as_stored(picture(2, 2), options)), std::invalid_argument);
    }
    EXPECT_EQ(files_in_folder(), 0u);
}

// D65 with Y = 1 is RGB (1, 1, 1), to any other reader of the file as well.
TEST_F(ExrFile, WhiteIsRgbOne) {
    Image<XYZ> image(1, 1);
    image(0, 0) = {0.3127f / 0.329f, 1.0f, (1.0f - 0.3127f - 0.329f) / 0.329f};
    write_exr(file("a.exr"), image, {}, {.space = "sRGB"});
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
    for (const ExrCompression& compression : {ExrCompression(NoCompression{}), ExrCompression(ZipCompression{})}) {
        const ExrOptions options{.compression = compression};
        write_exr(file("whole.exr"), picture(64, 200), metadata(), options);
        const std::uint64_t size = fs::file_size(file("whole.exr"));
        Imf::setGlobalThreadCount(0);  // a forked process has none of the pool's threads, and would wait for them
        for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{100}, size / 2, size - 1}) {
            write_bytes(file("old.exr"), "old");
            EXPECT_EXIT(write_with_limit(file("old.exr"), options, limit), testing::ExitedWithCode(0), "") << limit;
            EXPECT_EQ(read_text(file("old.exr")), "old");
            EXPECT_EQ(files_in_folder(), 2u);
        }
        EXPECT_EXIT(write_with_limit(file("old.exr"), options, size), testing::ExitedWithCode(1), "")
            << "the limit that just suffices must not fail: then the limits above test nothing";
    }
}

}  // namespace
}  // namespace emulsion
