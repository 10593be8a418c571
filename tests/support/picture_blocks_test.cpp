#include "support/picture_blocks.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/random.h"
#include "support/kolmogorov_smirnov.h"

namespace emulsion::testing {
namespace {

constexpr int kSize_px = 160, kBlock_px = 16;

/// A picture of slopes and an edge, with multiplicative noise that hits X, Y and Z together, and noise of each.
Image<XYZ> noisy(std::uint64_t seed, float noise) {
    Image<XYZ> picture(kSize_px, kSize_px);
    Pcg32 random(seed);
    const auto factor = [&] { return 1.0f + noise * (random.next_float() - 0.5f); };
    for (int y = 0; y < kSize_px; ++y) {
        for (int x = 0; x < kSize_px; ++x) {
            const float common = (x + y > 150 ? 3.0f : 0.5f + 0.004f * static_cast<float>(x)) * factor();
            picture(x, y) = {0.8f * common * factor(), common * factor(), 0.4f * common * factor()};
        }
    }
    return picture;
}

void tint(Image<XYZ>& picture, const PixelBounds& where, const XYZ& by) {
    for (int y = where.y0; y < where.y1; ++y) {
        for (int x = where.x0; x < where.x1; ++x) {
            XYZ& pixel = picture(x, y);
            pixel = {pixel.x * by.x, pixel.y * by.y, pixel.z * by.z};
        }
    }
}

std::vector<PictureDifference> blocks_of(const Image<XYZ>& picture, const Image<XYZ>& reference) {
    return block_differences(picture.view(), reference.view(), kBlock_px);
}

// Scenes agree: what is left looks like noise, in every measure.
TEST(PictureBlocks, DifferencesOfNoiseAreNormal) {
    std::vector<double> luminance, x, y;
    for (const PictureDifference& block : blocks_of(noisy(1, 0.4f), noisy(2, 0.2f))) {
        luminance.push_back(block.luminance.z());
        x.push_back(block.x.z());
        y.push_back(block.y.z());
    }
    EXPECT_EQ(luminance.size(), 100u);
    EXPECT_GT(normality_test(luminance).p_value, 1e-3);
    EXPECT_GT(normality_test(x).p_value, 1e-3);
    EXPECT_GT(normality_test(y).p_value, 1e-3);
}

TEST(PictureBlocks, FindABlockThatIsBrighter) {
    Image<XYZ> picture = noisy(1, 0.4f);
    tint(picture, {32, 48, 48, 64}, {1.1f, 1.1f, 1.1f});
    const auto blocks = blocks_of(picture, noisy(2, 0.2f));
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        EXPECT_EQ(std::abs(blocks[i].luminance.z()) > 4.0, i == 3 * 10 + 2) << i;
        EXPECT_LT(std::abs(blocks[i].x.z()), 4.0) << i;
    }
    EXPECT_NEAR(blocks[32].luminance.value, 0.1, 4.0 * blocks[32].luminance.standard_error);
}

TEST(PictureBlocks, FindAnotherColourOfTheSameLuminance) {
    Image<XYZ> picture = noisy(1, 0.4f);
    tint(picture, {0, 0, 16, 16}, {1.15f, 1.0f, 1.0f});
    const auto blocks = blocks_of(picture, noisy(2, 0.2f));
    EXPECT_LT(std::abs(blocks[0].luminance.z()), 4.0);
    EXPECT_GT(blocks[0].x.z(), 4.0);
    EXPECT_LT(std::abs(blocks[1].x.z()), 4.0);
    // From x = 0.8/2.2 to 0.92/2.32.
    EXPECT_NEAR(blocks[0].x.value, 0.92 / 2.32 - 0.8 / 2.2, 4.0 * blocks[0].x.standard_error);
}

TEST(PictureBlocks, OfTheWholePicture) {
    Image<XYZ> picture = noisy(1, 0.4f);
    const Image<XYZ> reference = noisy(2, 0.2f);
    EXPECT_LT(std::abs(picture_difference(picture.view(), reference.view()).luminance.z()), 4.0);
    tint(picture, {0, 0, kSize_px, kSize_px}, {1.0f, 1.01f, 1.0f});
    const PictureDifference difference = picture_difference(picture.view(), reference.view());
    EXPECT_NEAR(difference.luminance.value, 0.01, 4.0 * difference.luminance.standard_error);
    EXPECT_LT(difference.luminance.standard_error, 0.0025);
}

TEST(PictureBlocks, OfEqualPicturesAreNone) {
    const Image<XYZ> picture = noisy(1, 0.4f);
    for (const PictureDifference& block : blocks_of(picture, picture)) {
        EXPECT_EQ(block.luminance.z(), 0.0);
        EXPECT_EQ(block.x.z(), 0.0);
        EXPECT_EQ(block.y.z(), 0.0);
    }
}

TEST(PictureBlocks, RefuseWhatTheyCannotCompare) {
    const Image<XYZ> picture = noisy(1, 0.4f), smaller(16, 160), black(kSize_px, kSize_px);
    EXPECT_THROW((void)blocks_of(picture, smaller), std::invalid_argument);
    EXPECT_THROW((void)blocks_of(picture, black), std::invalid_argument);
    EXPECT_THROW((void)block_differences(picture.view(), picture.view(), 1), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion::testing
