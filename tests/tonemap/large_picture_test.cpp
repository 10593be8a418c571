// Every operator on 33 megapixels. scripts/test runs two of them, and all if asked with --long.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/row_blocks.h"
#include "every_tone_mapper.h"
#include "test_pictures.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

constexpr int kWidth = 8192, kHeight = 4096;
constexpr int kRowStep = 97, kColumnStep = 31;  // of what is sampled; primes, so that samples are of all blocks

/// Ten octaves across by ten down, with noise, for which one multiplication is enough. Bad pixels first, last and
/// within.
const Image<XYZ>& large_scene() {
    static const Image<XYZ> picture = [] {
        Image<XYZ> scene(kWidth, kHeight);
        std::vector<float> across(kWidth);
        for (int x = 0; x < kWidth; ++x) across[x] = std::exp2(5.0f * std::sin(0.013f * static_cast<float>(x)));
        parallel_for_rows(kWidth, kHeight, 0, [&](int y) {
            const float down = std::exp2(5.0f * std::cos(0.007f * static_cast<float>(y)));
            std::uint32_t noise = 2654435761u * static_cast<std::uint32_t>(y + 1);
            for (int x = 0; x < kWidth; ++x) {
                noise = 1664525u * noise + 1013904223u;
                const float luminance = across[x] * down * (1.0f + 0x1p-26f * static_cast<float>(noise >> 8));
                scene(x, y) = {0.9f * luminance, luminance, 1.2f * luminance};
            }
        });
        scene(0, 0) = grey(std::numeric_limits<float>::quiet_NaN());
        scene(5000, 1000) = scene(5001, 1000) = grey(std::numeric_limits<float>::infinity());
        scene(100, 4000) = grey(-1.0f);
        scene(kWidth - 1, kHeight - 1) = grey(std::numeric_limits<float>::quiet_NaN());
        scene(4096, 2048) = {};
        return scene;
    }();
    return picture;
}

class LargePicture : public EveryToneMapper {
  protected:
    static void map_into(Image<XYZ>& display, int threads) {
        const LuminanceStatistics found =
            tone_map_into({GetParam()}, large_scene().view(), display.view(), kWhite, threads);
        EXPECT_EQ(found.counts, (PixelCounts{std::int64_t{kWidth} * kHeight - 6, 1, 1, 2, 2}));
        EXPECT_EQ(found.first_bad_px, std::make_pair(0, 0));
    }
};

std::vector<XYZ> sampled_rows(const Image<XYZ>& image) {
    std::vector<XYZ> samples;
    for (int y = 0; y < kHeight; y += kRowStep) {
        samples.insert(samples.end(), image.row(y).begin(), image.row(y).end());
    }
    return samples;
}

void expect_exact_samples(const ToneMapper& mapper, const Image<XYZ>& display) {
    const Image<XYZ>& scene = large_scene();
    const SceneLuminance luminance(scene.view(), luminance_statistics_reference(scene.view()), 0);
    const double adaptation = adapt_reference(own_adaptation(mapper), scene.view(), luminance).uniform_cdm2;
    const ToneReproduction reproduction = prepare(mapper, luminance, adaptation);
    for (int y = 1; y < kHeight; y += kRowStep) {
        for (int x = 0; x < kWidth; x += kColumnStep) {
            const XYZ& pixel = scene(x, y);
            const double scale = reproduction.scale(pixel.y, adaptation);
            expect_close(display(x, y), {scale * pixel.x, scale * pixel.y, scale * pixel.z},
                         std::to_string(x) + ", " + std::to_string(y));
            if (testing::Test::HasFailure()) return;
        }
    }
}

TEST_P(LargePicture, ComesOutSoundAndTheSameForOneThreadAndTwo) {
    Image<XYZ> display(kWidth, kHeight);
    map_into(display, 2);
    expect_sound(display);
    const auto lit = std::count_if(display.pixels().begin(), display.pixels().end(),
                                   [](const XYZ& pixel) { return pixel.y > 1.0f / 255.0f; });
    EXPECT_GT(lit, std::int64_t{kWidth} * kHeight / 10);
    if (!is_local(GetParam())) expect_exact_samples(GetParam(), display);
    const std::vector<XYZ> of_two_threads = sampled_rows(display);
    map_into(display, 1);
    EXPECT_TRUE(sampled_rows(display) == of_two_threads);
}

INSTANTIATE_TEST_SUITE_P(Short, LargePicture, testing::Values(ReinhardGlobal{}, HighContrast{}), mapper_name);
INSTANTIATE_TEST_SUITE_P(Long, LargePicture, testing::ValuesIn(all_mappers()), mapper_name);

}  // namespace
}  // namespace emulsion
