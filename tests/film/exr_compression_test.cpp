// Every compression, with both pixel types and every space.

#include "film/exr_compression.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>

#include "core/named_value.h"
#include "exr_fixture.h"
#include "film/exr_channels.h"
#include "film/exr_file.h"

namespace emulsion {
namespace {

/// Near-neutral colours over a factor of three. In a block of 4x4 no two values of a channel differ by more than 9 %:
/// the slope is 1.004 a pixel both ways, the noise of all three 4 %, that of each 0.1 %, of which a matrix makes up to
/// six times as much. All channels are positive in every space.
Image<XYZ> smooth_picture(int width, int height) {
    Image<XYZ> image(width, height);
    Pcg32 random(3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto grain = [&](float size) { return 1.0f + size * (random.next_float() - 0.5f); };
            const float luminance = 0.1f * std::pow(1.004f, static_cast<float>(x + y)) * grain(0.04f);
            image(x, y) = {0.96f * luminance * grain(0.001f), luminance * grain(0.001f), luminance * grain(0.001f)};
        }
    }
    return image;
}

/// The largest difference of a component, relative to what is expected.
double largest_error(const Image<XYZ>& found, const Image<XYZ>& expected) {
    double largest = 0.0;
    for (std::size_t i = 0; i < expected.pixels().size(); ++i) {
        const XYZ &a = found.pixels()[i], &b = expected.pixels()[i];
        for (const auto& [is, was] : {std::pair(a.x, b.x), std::pair(a.y, b.y), std::pair(a.z, b.z)}) {
            largest = std::max(largest, static_cast<double>(std::abs(is - was) / std::abs(was)));
        }
    }
    return largest;
}

/// What a lossy compression may change of the channels of smooth_picture().
/// pxr24 rounds to 15 bits of fraction: 2^-16. b44 stores the differences of a block in 6 bits, in steps of D / 31 at
/// most where D is the largest difference in numbers of halves, 1024 to an octave; 9 % are 128 of them, so that it is
/// off by 128 / 31 + 1 < 6 of them, each 2^-10 at most. dwaa and dwab quantise a cosine transform, and promise nothing:
/// 5 % is what their default level is held to here, under noise of 4 %.
double lossy_bound(const ExrCompression& compression, PixelType type) {
    const bool is_half = type == PixelType::half;
    if (std::holds_alternative<Pxr24Compression>(compression)) return is_half ? 0.0 : 0x1p-16;
    if (std::holds_alternative<B44Compression>(compression)) return is_half ? 6 * 0x1p-10 : 0.0;
    if (std::holds_alternative<B44aCompression>(compression)) return is_half ? 6 * 0x1p-10 : 0.0;
    return 0.05;
}

template <class Check>
void for_each_combination(const Check& check) {
    for_each_alternative<ExrCompression>([&](const auto& compression) {
        for (const PixelType type : {PixelType::float32, PixelType::half}) {
            for (const std::string& space : exr_space_names()) {
                SCOPED_TRACE(space + " " + to_text(compression) + (type == PixelType::half ? " half" : " float"));
                check(ExrOptions{.space = space, .pixel_type = type, .compression = compression});
            }
        }
    });
}

TEST_F(ExrFile, LosslessCompressionsKeepEveryBit) {
    Image<XYZ> image = picture(37, 70);
    image(5, 5) = {-0.0f, 1e-40f, 1e30f};
    for_each_combination([&](const ExrOptions& options) {
        if (is_lossy(options.compression)) return;
        write_exr(file("a.exr"), image, metadata(), options);
        const FilmImage read = read_exr(file("a.exr"));
        EXPECT_TRUE(same_bits(read.xyz, as_stored(image, options)));
        EXPECT_EQ(read.metadata, metadata());
        EXPECT_THAT(read.notes, testing::IsEmpty());
    });
}

TEST_F(ExrFile, LossyCompressionsKeepTheirBounds) {
    const Image<XYZ> image = smooth_picture(150, 140);
    int changed = 0;
    for_each_combination([&](const ExrOptions& options) {
        if (!is_lossy(options.compression)) return;
        write_exr(file("a.exr"), image, {}, options);
        ExrOptions lossless = options;
        lossless.compression = ZipCompression{};
        const double error = largest_error(read_exr(file("a.exr")).xyz, as_stored(image, lossless));
        // A component of XYZ is a sum of channels; where one has a negative share, the errors' sum is larger than the
        // component's, for these colours in these spaces less than twice.
        const double shares = options.space == kXyzSpaceName ? 1.0 : 2.0;
        EXPECT_LE(error, shares * lossy_bound(options.compression, options.pixel_type) + 1e-6);
        if (error > 1e-6) ++changed;
    });
    // Of each of 13 spaces: pxr24 changes floats, b44 and b44a halves, dwaa and dwab both.
    EXPECT_EQ(changed, 13 * (1 + 2 + 4)) << "a bound that nothing comes near tests nothing";
}

TEST_F(ExrFile, CompressionsAreThoseOfTheHeader) {
    int number = 0;
    for_each_alternative<ExrCompression>([&](const auto& compression) {
        write_exr(file("a.exr"), picture(4, 4), {}, {.compression = compression});
        EXPECT_EQ(static_cast<int>(Imf::InputFile(file("a.exr").c_str()).header().compression()), number++);
    });
    EXPECT_EQ(number, 10);
}

TEST_F(ExrFile, DwaLevelsCount) {
    const Image<XYZ> image = smooth_picture(150, 140);
    write_exr(file("fine.exr"), image, {}, {.compression = parse_named<ExrCompression>("dwaa:level=5", "compression")});
    write_exr(file("coarse.exr"), image, {}, {.compression = DwaaCompression{.level = 500.0}});
    EXPECT_GT(fs::file_size(file("fine.exr")), fs::file_size(file("coarse.exr")));
}

TEST_F(ExrFile, RefusesUnknownSpacesAndLevelsOutOfRange) {
    const auto refused = [&](const ExrOptions& options, const char* what) {
        EXPECT_THAT([&] { write_exr(file("a.exr"), picture(2, 2), {}, options); },
                    ThrowsMessage<std::invalid_argument>(testing::HasSubstr(what)));
        EXPECT_THROW(static_cast<void>(as_stored(picture(2, 2), options)), std::invalid_argument);
    };
    refused({.space = "sRBG"}, "sRGB");
    refused({.compression = DwabCompression{.level = -1.0}}, "level");
    refused({.threads = -1}, "threads");
    EXPECT_EQ(files_in_folder(), 0u);
}

TEST_F(ExrFile, NobodyButTheFileKnowsWhatALossyCompressionStores) {
    EXPECT_THAT([] { static_cast<void>(as_stored(picture(2, 2), {.compression = DwaaCompression{}})); },
                ThrowsMessage<std::invalid_argument>(testing::HasSubstr("dwaa:level=45")));
}

// Chromaticities are in single precision, and the matrix is made from them as they are in the file.
TEST(ExrSpaces, AreStoredInSinglePrecision) {
    EXPECT_FALSE(space_as_stored("xyz"));
    const auto space = space_as_stored("display-p3");
    ASSERT_TRUE(space);
    EXPECT_EQ(space->name, "Display_P3");
    EXPECT_EQ(space->white.x, static_cast<double>(0.3127f));
    EXPECT_EQ(space->red.x, static_cast<double>(0.68f));
}

}  // namespace
}  // namespace emulsion
