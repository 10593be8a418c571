// Pictures of 16-bit floats: what is above their largest, below their least, and in steps too wide between.

#include <Imath/half.h>
#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "support/temporary_folder.h"

namespace emulsion {
namespace {

// The sun's disc of 1.6e9 cd/m^2, sunlit paper of 3e4, a night sky of 1e-8.
TEST(Halves, HoldNeitherTheSunNorTheNight) {
    EXPECT_TRUE(static_cast<Imath::half>(1.6e9f).isInfinity());
    EXPECT_TRUE(static_cast<Imath::half>(1e-8f).isZero());

    Image<XYZ> image(3, 1);
    image(0, 0) = {1.6e9f, 1.6e9f, 1.6e9f};
    image(1, 0) = {3e4f, 3e4f, 3e4f};
    image(2, 0) = {1e-8f, 1e-8f, 1e-8f};
    const TemporaryFolder folder;
    const ExrWriteResult lost = write_exr(folder.file("half.exr"), image, {}, {.pixel_type = PixelType::half});
    // The end of the range in the place of infinity, and each loss is counted.
    EXPECT_EQ(lost.too_high_count, 3);
    EXPECT_EQ(lost.vanished_positive_count, 3);
    EXPECT_EQ(read_exr(folder.file("half.exr")).xyz(0, 0).y, 65504.0f);
    // Floats hold all of it, and are the default.
    EXPECT_EQ(write_exr(folder.file("float.exr"), image, {}), ExrWriteResult{});
    EXPECT_EQ(read_exr(folder.file("float.exr")).xyz, image);
    // With 1 for 30000 cd/m^2 halves hold paper, and the sun still not: whiteLuminance scales, and says so in the file.
    const ExrWriteResult scaled =
        write_exr(folder.file("scaled.exr"), image, {}, {.pixel_type = PixelType::half, .white_luminance_cdm2 = 3e4});
    EXPECT_EQ(scaled.too_high_count, 3);
}

// A running mean in halves: from 2048 on, adding 1 changes nothing.
TEST(Halves, StopGrowingAt2048) {
    Imath::half sum = 0.0f;
    for (int i = 0; i < 4096; ++i) sum += Imath::half(1.0f);
    EXPECT_EQ(static_cast<float>(sum), 2048.0f);
}

}  // namespace
}  // namespace emulsion
