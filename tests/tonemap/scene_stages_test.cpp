// Properties of the stages before the tone curve: each test runs for every alternative of their variants.

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/named_value.h"
#include "core/random.h"
#include "test_pictures.h"
#include "tonemap/bloom.h"
#include "tonemap/pixel_class.h"
#include "tonemap/vision.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

struct Stage {
    std::string name;
    std::function<Image<XYZ>(const Image<XYZ>&, int threads)> apply;
};

std::ostream& operator<<(std::ostream& out, const Stage& stage) { return out << stage.name; }

std::vector<Stage> all_stages() {
    std::vector<Stage> stages;
    for_each_alternative<Bloom>([&]<class T>(const T& bloom) {
        stages.push_back({"bloom_" + std::string(T::kName), [bloom](const Image<XYZ>& scene, int threads) {
                              return add_bloom(bloom, scene.view(), threads);
                          }});
    });
    for_each_alternative<Vision>([&]<class T>(const T& vision) {
        stages.push_back({"vision_" + std::string(T::kName), [vision](const Image<XYZ>& scene, int threads) {
                              return see(vision, scene.view(), threads);
                          }});
    });
    return stages;
}

class EverySceneStage : public testing::TestWithParam<Stage> {
  protected:
    [[nodiscard]] static Image<XYZ> apply(const Image<XYZ>& scene, int threads = 1) {
        return GetParam().apply(scene, threads);
    }
};

bool is_sound(const XYZ& p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && p.y >= 0.0f;
}

bool same_bits(const XYZ& a, const XYZ& b) noexcept {
    const auto same = [](float p, float q) { return std::bit_cast<unsigned>(p) == std::bit_cast<unsigned>(q); };
    return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

void expect_near(const XYZ& found, const XYZ& expected, double relative) {
    const double scale = relative * (std::abs(expected.x) + std::abs(expected.y) + std::abs(expected.z));
    EXPECT_NEAR(found.x, expected.x, scale);
    EXPECT_NEAR(found.y, expected.y, scale);
    EXPECT_NEAR(found.z, expected.z, scale);
}

TEST_P(EverySceneStage, BlackStaysBlack) {
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 1009}, {1009, 1}, {31, 37}}) {
        const Image<XYZ> result = apply(Image<XYZ>(width, height));
        for (const XYZ& pixel : result.pixels()) EXPECT_EQ(pixel, XYZ{});
    }
}

// In photopic light: in the dark, the colour of a constant changes, and vision_test.cpp says to what.
TEST_P(EverySceneStage, ConstantStaysConstant) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {1, 1009}, {1009, 1}, {127, 131}, {128, 64}}) {
        Image<XYZ> scene(width, height);
        for (XYZ& pixel : scene.pixels()) pixel = {90.0f, 100.0f, 110.0f};
        const Image<XYZ> result = apply(scene);
        for (const XYZ& pixel : result.pixels()) expect_near(pixel, scene(0, 0), 1e-6);
    }
}

TEST_P(EverySceneStage, SoundFromAnyBits) {
    Pcg32 random(21);
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 211}, {211, 1}, {61, 67}}) {
        Image<XYZ> scene(width, height);
        for (XYZ& pixel : scene.pixels()) {
            pixel = {std::bit_cast<float>(random.next()), std::bit_cast<float>(random.next()),
                     std::bit_cast<float>(random.next())};
        }
        const Image<XYZ> result = apply(scene);
        for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
            const XYZ before = scene.pixels()[i], after = result.pixels()[i];
            if (is_bad(classify(before))) {
                EXPECT_TRUE(same_bits(before, after)) << i;
            } else {
                EXPECT_TRUE(is_sound(after)) << i << ": " << after.x << " " << after.y << " " << after.z;
            }
        }
    }
}

TEST_P(EverySceneStage, SoundInEveryDecade) {
    for (int decade = -44; decade <= 34; ++decade) {
        Image<XYZ> scene = random_scene(17, 13, 22);
        const auto factor = static_cast<float>(std::pow(10.0, decade));
        for (XYZ& pixel : scene.pixels()) pixel = factor * pixel;
        const Image<XYZ> result = apply(scene);
        EXPECT_TRUE(std::all_of(result.pixels().begin(), result.pixels().end(), is_sound)) << decade;
        if (decade >= -38) {
            EXPECT_TRUE(std::any_of(result.pixels().begin(), result.pixels().end(), [](const XYZ& pixel) {
                return pixel.y > 0.0f;
            })) << decade;
        }
    }
}

TEST_P(EverySceneStage, HalfBlackIsSound) {
    Image<XYZ> scene = random_scene(64, 48, 23);
    for (int y = 0; y < 24; ++y) std::fill(scene.row(y).begin(), scene.row(y).end(), XYZ{});
    const Image<XYZ> result = apply(scene);
    EXPECT_TRUE(std::all_of(result.pixels().begin(), result.pixels().end(), is_sound));
}

// A constant in which some pixels are bad: the others do not know of them.
TEST_P(EverySceneStage, BadPixelsNeitherSpreadNorChange) {
    Image<XYZ> scene(67, 61);
    for (XYZ& pixel : scene.pixels()) pixel = {90.0f, 100.0f, 110.0f};
    scene(20, 20) = {kNan, 1.0f, 1.0f};
    scene(21, 20) = {kInf, kInf, kInf};
    scene(22, 20) = {1.0f, -1e30f, 1.0f};
    scene(0, 60) = {1.0f, 1.0f, -kInf};
    const Image<XYZ> result = apply(scene);
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
        const XYZ before = scene.pixels()[i], after = result.pixels()[i];
        if (is_bad(classify(before))) {
            EXPECT_TRUE(same_bits(before, after)) << i;
        } else {
            expect_near(after, before, 1e-6);
        }
    }
}

TEST_P(EverySceneStage, AllBadStaysAsItIs) {
    Image<XYZ> scene(9, 7);
    for (XYZ& pixel : scene.pixels()) pixel = {1.0f, -1.0f, 1.0f};
    EXPECT_EQ(apply(scene), scene);
}

TEST_P(EverySceneStage, TurnsAndMirrorsWithThePicture) {
    const Image<XYZ> scene = random_scene(101, 67, 24);
    Image<XYZ> turned(67, 101), flipped(101, 67);
    for (int y = 0; y < 67; ++y) {
        for (int x = 0; x < 101; ++x) {
            turned(66 - y, x) = scene(x, y);
            flipped(100 - x, y) = scene(x, y);
        }
    }
    const Image<XYZ> plain = apply(scene), of_turned = apply(turned), of_flipped = apply(flipped);
    for (int y = 0; y < 67; ++y) {
        for (int x = 0; x < 101; ++x) {
            expect_near(of_turned(66 - y, x), plain(x, y), 1e-5);
            expect_near(of_flipped(100 - x, y), plain(x, y), 1e-5);
        }
    }
}

TEST_P(EverySceneStage, SameBitsForEveryNumberOfThreads) {
    Image<XYZ> scene = random_scene(509, 251, 25);
    scene(100, 100).y = kNan;
    const Image<XYZ> one = apply(scene, 1);
    for (const int threads : {2, 3, 8, 0}) {
        const Image<XYZ> other = apply(scene, threads);
        EXPECT_TRUE(std::equal(one.pixels().begin(), one.pixels().end(), other.pixels().begin(), same_bits)) << threads;
    }
}

TEST_P(EverySceneStage, RejectsAnEmptyPicture) { EXPECT_THROW((void)apply(Image<XYZ>()), std::invalid_argument); }

INSTANTIATE_TEST_SUITE_P(Variants, EverySceneStage, testing::ValuesIn(all_stages()),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace emulsion
