// Properties that every operator has: each test runs for every alternative of the variant. More of them, of unusual
// pictures and parameters: tone_mapper_extremes_test.cpp.

#include "tonemap/tone_mapper.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "every_tone_mapper.h"
#include "test_pictures.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

TEST_P(EveryToneMapper, AgreesWithItsTwin) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 1009}, {1009, 1}, {2, 3}, {127, 131}}) {
        expect_twin(GetParam(), random_scene(width, height, 5));
    }
}

// Every float, bad ones included, in every component: the darkest and the brightest pixel are 76 decades apart.
TEST_P(EveryToneMapper, AgreesWithItsTwinOnAnyBits) {
    Pcg32 random(6);
    Image<XYZ> scene(211, 223);
    for (XYZ& pixel : scene.pixels()) {
        pixel = {std::bit_cast<float>(random.next()), std::bit_cast<float>(random.next()),
                 std::bit_cast<float>(random.next())};
    }
    expect_twin(GetParam(), scene);
}

// Pictures that are as a whole far from 1 cd/m^2, down to denormals.
TEST_P(EveryToneMapper, AgreesWithItsTwinInEveryDecade) {
    for (int decade = -44; decade <= 34; ++decade) {
        Image<XYZ> scene = random_scene(16, 16, 7);
        const auto factor = static_cast<float>(std::pow(10.0, decade));
        for (XYZ& pixel : scene.pixels()) pixel = factor * pixel;
        expect_twin(GetParam(), scene);
    }
}

TEST_P(EveryToneMapper, BlackStaysBlack) {
    const Image<XYZ> mapped = map(Image<XYZ>(7, 3));
    for (const XYZ& pixel : mapped.pixels()) EXPECT_EQ(pixel, XYZ{});
}

TEST_P(EveryToneMapper, ConstantStaysConstantAndIsNotBlack) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 4099}, {4099, 1}, {31, 37}}) {
        Image<XYZ> scene(width, height);
        for (XYZ& pixel : scene.pixels()) pixel = {90.0f, 100.0f, 110.0f};
        const Image<XYZ> mapped = map(scene);
        EXPECT_GT(mapped(0, 0).y, 0.0f);
        for (const XYZ& pixel : mapped.pixels()) EXPECT_EQ(pixel, mapped(0, 0));
    }
}

TEST_P(EveryToneMapper, OneBrightPixelAmongBlackIsShown) {
    Image<XYZ> scene(5, 5);
    scene(2, 2) = grey(3.0f);
    const Image<XYZ> mapped = map(scene);
    EXPECT_GT(mapped(2, 2).y, 0.02f);
    EXPECT_LE(mapped(2, 2).y, 1.0f + 1e-6f);
    EXPECT_EQ(mapped(0, 0), XYZ{});
}

TEST_P(EveryToneMapper, KeepsChromaticity) {
    const Image<XYZ> scene = random_scene(64, 64, 8);
    const Image<XYZ> mapped = map(scene);
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
        const XYZ before = scene.pixels()[i], after = mapped.pixels()[i];
        if (after == XYZ{}) continue;  // black has none
        EXPECT_NEAR(after.x / after.y, before.x / before.y, 1e-6f);
        EXPECT_NEAR(after.z / after.y, before.z / before.y, 1e-6f);
    }
}

// The twin for any two pixels; the fast one to the tolerance of its table. 12 decades, those past the robust ends too.
TEST_P(EveryToneMapper, IsMonotone) {
    const ToneMapping mapping = with_global_adaptation(GetParam());
    const Image<XYZ> ramp = ramp_of_greys(1e-6, 1e6, 20000);
    const Image<XYZ> mapped = tone_map(mapping, ramp.view(), kWhite, 0).image;
    const Image<XYZd> exact = tone_map_reference(mapping, ramp.view(), kWhiteD);
    for (int x = 1; x < ramp.width(); ++x) {
        ASSERT_GE(mapped(x, 0).y, mapped(x - 1, 0).y * (1.0f - 2e-4f)) << x;
        ASSERT_GE(exact(x, 0).y, exact(x - 1, 0).y * (1.0 - 1e-13)) << x;
    }
}

// In units that are a power of two apart, the bins of the histogram are the same. In others, the robust ends of the
// range move within their bins, which are up to 3.1 % wide.
TEST_P(EveryToneMapper, DependsOnTheUnitAsItSays) {
    const UnitOfLuminance unit = traits_of(GetParam()).unit;
    const Image<XYZ> scene = random_scene(61, 67, 9);
    const Image<XYZ> mapped = map(scene);
    for (const float factor : {1e-12f, 1e-30f, 1e12f, 1e30f, 0x1p-40f, 0x1p-80f, 0x1p40f, 0x1p80f}) {
        Image<XYZ> other = scene;
        for (XYZ& pixel : other.pixels()) pixel = factor * pixel;
        const auto [of_shown, relative] = differences(mapped, map(other));
        int exponent = 0;
        const bool is_power_of_2 = std::frexp(factor, &exponent) == 0.5f;
        if (unit == UnitOfLuminance::absolute) {
            EXPECT_GT(relative, 2e-4f) << factor;
        } else if (unit == UnitOfLuminance::cancels || is_power_of_2) {
            EXPECT_LE(relative, 2e-4f) << factor;
        }
        if (unit == UnitOfLuminance::nearly_cancels) {
            EXPECT_LE(of_shown, 4.0f / 255.0f) << factor;
        }
    }
}

// Six of 4096 pixels, next to each other: those that can be seen move as far as beside a single one.
TEST_P(EveryToneMapper, BadPixelsBecomeDefinedAndLeaveTheOthers) {
    const Image<XYZ> clean = scene_for(GetParam(), 64, 64, 10);
    const Image<XYZ> clean_mapped = map(clean);
    Image<XYZ> scene = clean;
    scene(33, 32) = {1.0f, kNan, 1.0f};
    scene(34, 32) = {kNan, 1.0f, 1.0f};
    scene(35, 32) = {1.0f, -1.0f, 1.0f};
    scene(36, 32) = {1.0f, -kInf, 1.0f};
    scene(37, 32) = {kInf, kInf, kInf};
    scene(38, 32) = {-kInf, 1.0f, 1.0f};
    const ToneMapResult result = tone_map({GetParam()}, scene.view(), kWhite, 1);
    EXPECT_EQ(result.statistics.counts, (PixelCounts{64 * 64 - 6, 0, 2, 2, 2}));
    EXPECT_EQ(result.statistics.first_bad_px, std::make_pair(33, 32));
    for (int x = 33; x <= 36; ++x) EXPECT_EQ(result.image(x, 32), XYZ{}) << x;
    for (int x = 37; x <= 38; ++x) EXPECT_EQ(result.image(x, 32), kWhite) << x;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            if (y == 32 && x >= 33 && x <= 38) continue;
            EXPECT_NEAR(shown(result.image(x, y)), shown(clean_mapped(x, y)), most_move(GetParam())) << x << ", " << y;
        }
    }
}

// Every other pixel, those next to it, too. Of fewer than a thousand pixels one has a weight that shows.
TEST_P(EveryToneMapper, OutlierDoesToTheOthersWhatItSays) {
    const bool darkens = traits_of(GetParam()).outliers == OutlierEffect::darkens_all;
    std::vector<std::pair<int, int>> sizes = {{32, 32}, {64, 64}};
    if (!is_local(GetParam())) sizes.insert(sizes.end(), {{1000, 1}, {1, 1009}});
    for (const auto& [width, height] : sizes) {
        for (unsigned seed = 0; seed < 6; ++seed) {
            const Image<XYZ> clean = scene_for(GetParam(), width, height, seed);
            const Image<XYZ> clean_mapped = map(clean);
            const std::size_t outlier = static_cast<std::size_t>(width) * static_cast<std::size_t>(height / 2) +
                                        static_cast<std::size_t>(width / 3);
            Image<XYZ> scene = clean;
            scene.pixels()[outlier] = grey(1e30f);
            Image<XYZ> mapped = map(scene);
            if (darkens) {
                for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
                    if (i == outlier) continue;
                    EXPECT_LT(shown(mapped.pixels()[i]), 1e-6f);
                }
                continue;
            }
            mapped.pixels()[outlier] = clean_mapped.pixels()[outlier];
            EXPECT_LE(differences(clean_mapped, mapped).first, most_move(GetParam())) << width << 'x' << height;
        }
    }
}

TEST_P(EveryToneMapper, PictureOfBadPixelsOnlyIsDefined) {
    Image<XYZ> scene(3, 1);
    scene(0, 0) = grey(kNan);
    scene(1, 0) = grey(-1.0f);
    scene(2, 0) = grey(kInf);
    const Image<XYZ> mapped = map(scene);
    EXPECT_EQ(mapped(0, 0), XYZ{});
    EXPECT_EQ(mapped(1, 0), XYZ{});
    EXPECT_EQ(mapped(2, 0), kWhite);
}

TEST_P(EveryToneMapper, HalfBlackLeavesTheOtherHalf) {
    const Image<XYZ> half = random_scene(64, 32, 11);
    Image<XYZ> scene(64, 64);
    std::copy(half.pixels().begin(), half.pixels().end(), scene.pixels().begin());
    const ToneMapping mapping = with_global_adaptation(GetParam());
    const Image<XYZ> half_mapped = tone_map(mapping, half.view(), kWhite, 1).image;
    const Image<XYZ> mapped = tone_map(mapping, scene.view(), kWhite, 1).image;
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 64; ++x) EXPECT_EQ(mapped(x, y), half_mapped(x, y));
    }
}

// The other half is black, or the first one mirrored. Neighbourhoods reach across; farther off nothing is to be seen.
TEST_P(EveryToneMapper, HalfBlackIsFarFromTheOtherHalf) {
    constexpr int kHeight = 128, kReach = 64;
    const Image<XYZ> half = smooth_scene(64, kHeight, 11);
    Image<XYZ> black(64, 2 * kHeight), mirrored(64, 2 * kHeight);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < 64; ++x) {
            black(x, y) = mirrored(x, y) = mirrored(x, 2 * kHeight - 1 - y) = half(x, y);
        }
    }
    const Image<XYZ> beside_black = map(black), beside_mirrored = map(mirrored);
    expect_sound(beside_black);
    float largest = 0.0f;
    for (int y = 0; y < kHeight - kReach; ++y) {
        for (int x = 0; x < 64; ++x) {
            largest = std::max(largest, std::abs(shown(beside_black(x, y)) - shown(beside_mirrored(x, y))));
        }
    }
    EXPECT_LE(largest, 2.0f / 255.0f);
}

TEST_P(EveryToneMapper, SameBitsForEveryNumberOfThreads) {
    const Image<XYZ> scene = random_scene(509, 251, 12);
    const Image<XYZ> one = map(scene, 1);
    for (const int threads : {2, 3, 8, 0}) EXPECT_EQ(map(scene, threads), one) << threads;
}

TEST_P(EveryToneMapper, WorksInPlace) {
    Image<XYZ> scene = random_scene(33, 35, 13);
    const Image<XYZ> mapped = map(scene);
    tone_map_into({GetParam()}, std::as_const(scene).view(), scene.view(), kWhite, 2);
    EXPECT_EQ(scene, mapped);
}

TEST_P(EveryToneMapper, RejectsWhatItCannotDo) {
    const Image<XYZ> scene(2, 2);
    Image<XYZ> smaller(2, 1);
    EXPECT_THROW((void)tone_map({GetParam()}, Image<XYZ>().view(), kWhite, 1), std::invalid_argument);
    EXPECT_THROW((void)tone_map({GetParam()}, scene.view(), kWhite, -1), std::invalid_argument);
    EXPECT_THROW(tone_map_into({GetParam()}, scene.view(), smaller.view(), kWhite, 1), std::invalid_argument);
}

TEST_P(EveryToneMapper, TextReadsBackAsTheSameValue) {
    EXPECT_EQ(parse_named<ToneMapper>(to_text(GetParam()), "tonemap"), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Variant, EveryToneMapper, testing::ValuesIn(all_mappers()), mapper_name);

TEST(ToneMapper, ReinhardGlobalIsTheDefault) { EXPECT_EQ(ToneMapper{}, ToneMapper{ReinhardGlobal{}}); }

TEST(MaxToWhite, BrightestPixelIsOneAndTheRestProportional) {
    Image<XYZ> scene(3, 1);
    scene(0, 0) = {10.0f, 50.0f, 20.0f};
    scene(1, 0) = grey(200.0f);
    scene(2, 0) = grey(kInf);
    const ToneMapResult result = tone_map({MaxToWhite{}}, scene.view(), kWhite, 1);
    EXPECT_FLOAT_EQ(result.image(0, 0).y, 0.25f);
    EXPECT_FLOAT_EQ(result.image(0, 0).x, 0.05f);
    EXPECT_FLOAT_EQ(result.image(1, 0).y, 1.0f);
    EXPECT_EQ(result.image(2, 0), kWhite);
}

}  // namespace
}  // namespace emulsion
