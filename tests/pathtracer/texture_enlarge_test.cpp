#include "pathtracer/texture_enlarge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/png_bytes.h"
#include "texture_image_fixture.h"

namespace emulsion {
namespace {

using testing::png_bytes;

TEST(TextureEnlarge, TexturesAreEnlargedToPowersOfTwo) {
    // 0 0.25 1 of three columns to four: weights by hand of sinc(x) sinc(x / 2) at 3/8 and 9/8 of a column.
    const std::string picture = png_bytes({.width = 3, .colour_type = 0}, std::array{0, 64, 255});
    const auto sinc = [](double x) { return x == 0.0 ? 1.0 : std::sin(std::numbers::pi * x) / (std::numbers::pi * x); };
    const auto weight = [&](double x) { return std::abs(x) < 2.0 ? sinc(x) * sinc(x / 2.0) : 0.0; };
    const std::array value = {0.0, 64 / 255.0, 1.0};
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::black}) {
        const Image<float> numbers =
            read_number_texels("x.png", picture, LinearTransfer{}, TextureFilter::bilinear, wrap);
        ASSERT_EQ(numbers.width(), 4);
        ASSERT_EQ(numbers.height(), 1);
        for (int x = 0; x < 4; ++x) {
            const double centre = (x + 0.5) * 0.75;
            double sum = 0.0, weights = 0.0;
            for (int i = -3; i < 6; ++i) {
                const int inside = wrap == TextureWrap::repeat ? (i + 3) % 3 : std::clamp(i, 0, 2);
                const bool is_black = wrap == TextureWrap::black && inside != i;
                sum += is_black ? 0.0 : weight(i + 0.5 - centre) * value.at(static_cast<std::size_t>(inside));
                weights += weight(i + 0.5 - centre);
            }
            // What goes beyond is cut off, as codes of 8 bits can't hold it; the rest is such a code.
            const double expected = std::clamp(sum / weights, 0.0, 1.0);
            EXPECT_NEAR(numbers(x, 0), std::round(255.0 * expected) / 255.0, 1e-6) << x;
        }
    }
}

TEST(TextureEnlarge, EnlargedTexelsOfSixteenBitsAreNotRounded) {
    const std::string picture =
        png_bytes({.width = 1, .height = 3, .bits = 16, .colour_type = 0}, std::array{0, 0, 65535});
    const Image<RGB> texels = read_rgb_texels("x.png", picture, LinearTransfer{}, TextureWrap::clamp).texels;
    ASSERT_EQ(texels.width(), 1);
    ASSERT_EQ(texels.height(), 4);
    EXPECT_LT(texels(0, 1).g, -0.001f) << "the filter goes beyond";
    EXPECT_GT(texels(0, 3).g, 1.001f);
    // As lights are: no wrap, no change.
    EXPECT_EQ(read_rgb_texels("x.png", picture, LinearTransfer{}).texels.height(), 3);
}

TEST(TextureEnlarge, WhatFitsIsNotEnlarged) {
    const std::string picture = png_bytes({.width = 2, .height = 2}, kFourColours);
    const Image<RGB> as_is = read_rgb_texels("x.png", picture).texels;
    EXPECT_EQ(read_rgb_texels("x.png", picture, {}, TextureWrap::repeat).texels, as_is);
}

TEST(TextureEnlarge, EvenPicturesStayEvenWhenEnlarged) {
    const std::string picture = png_bytes({.width = 5, .height = 3}, std::vector<int>(45, 77));
    for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp, TextureWrap::octahedral_sphere}) {
        const Image<RGB> texels = read_rgb_texels("x.png", picture, {}, wrap).texels;
        ASSERT_EQ(texels.width(), 8);
        ASSERT_EQ(texels.height(), 4);
        for (const RGB& texel : texels.pixels()) {
            expect_rgb(texel, srgb_decoded(77 / 255.0), srgb_decoded(77 / 255.0), srgb_decoded(77 / 255.0));
        }
    }
}

}  // namespace
}  // namespace emulsion
