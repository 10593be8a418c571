// The same .pbrt file means the same picture as in pbrt-v4: pictures that it rendered (tests/data/reference, whose
// README says how) against ours, block by block. Ours has a quarter of the samples, always under the box filter of the
// reference, so that pixels are independent.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "film/exr_file.h"
#include "pathtracer/render.h"
#include "pathtracer/scene_parser.h"
#include "support/picture_blocks.h"

namespace emulsion::testing {
namespace {

#ifdef EMULSION_SLOW_BUILD
constexpr int kSamplesPerPixel = 8;
#else
constexpr int kSamplesPerPixel = 128;
#endif

constexpr int kBlock_px = 16;

/// |t| > 4 of 255 degrees of freedom has a probability of 8e-5: chance puts one block outside in one of six runs of
/// five scenes with three measures each.
constexpr double kStandardErrors = 4.0;
constexpr double kShareOfBlocks = 0.999;

/// Of the mean of the picture, relative; with few samples as much as the noise explains.
constexpr double kMeanTolerance = 0.005;

Image<XYZ> rendered(const std::filesystem::path& file) {
    Scene scene = read_scene(file);
    scene.filter = BoxFilter{};
    Film film(film_options(scene));
    const PreparedScene prepared(std::move(scene), 0);
    RenderProgress progress;
    render(prepared, {.samples_per_pixel = kSamplesPerPixel, .seed = 3}, film, progress);
    EXPECT_EQ(film.dropped().count(), 0u);
    return film.xyz_image();
}

/// How many blocks differ by more than noise does.
template <class Measure>
void expect_blocks_agree(const std::vector<PictureDifference>& blocks, const Measure& measure, const char* name) {
    std::size_t outside = 0;
    double worst = 0.0;
    for (const PictureDifference& block : blocks) {
        const double z = std::abs(measure(block).z());
        worst = std::max(worst, z);
        outside += z > kStandardErrors ? 1 : 0;
    }
    const auto count = static_cast<double>(blocks.size());
    EXPECT_LE(static_cast<double>(outside), count * (1.0 - kShareOfBlocks))
        << name << ": " << outside << " of " << count << " blocks, the worst by " << worst << " standard errors";
}

void expect_mean_agrees(const Difference& difference, double of, const char* name) {
    double tolerance = kMeanTolerance * of;
    if (kSamplesPerPixel < 128) tolerance = std::max(tolerance, kStandardErrors * difference.standard_error);
    EXPECT_LE(std::abs(difference.value), tolerance) << name << ", standard error " << difference.standard_error;
}

class Reference : public ::testing::TestWithParam<const char*> {};

TEST_P(Reference, PictureIsThatOfPbrt) {
    const std::filesystem::path folder = EMULSION_SOURCE_DIR "/tests/data/reference";
    const Image<XYZ> reference = read_exr(folder / (std::string(GetParam()) + ".exr")).xyz;
    const Image<XYZ> picture = rendered(folder / (std::string(GetParam()) + ".pbrt"));

    const auto blocks = block_differences(picture.view(), reference.view(), kBlock_px);
    expect_blocks_agree(
        blocks, [](const PictureDifference& d) { return d.luminance; }, "luminance");
    expect_blocks_agree(
        blocks, [](const PictureDifference& d) { return d.x; }, "chromaticity x");
    expect_blocks_agree(
        blocks, [](const PictureDifference& d) { return d.y; }, "chromaticity y");

    const PictureDifference whole = picture_difference(picture.view(), reference.view());
    expect_mean_agrees(whole.luminance, 1.0, "luminance");
    // Relative to a chromaticity of a third.
    expect_mean_agrees(whole.x, 1.0 / 3.0, "chromaticity x");
    expect_mean_agrees(whole.y, 1.0 / 3.0, "chromaticity y");
}

std::string name_of(const ::testing::TestParamInfo<const char*>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Reference,
                         ::testing::Values("cornell-published-light", "cornell-fl11", "glass-dispersion", "metals",
                                           "rgb-still-life"),
                         name_of);

}  // namespace
}  // namespace emulsion::testing
