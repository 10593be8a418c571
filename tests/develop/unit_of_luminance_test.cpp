// What operators show of the same scene in other units of luminance: factors over an octave, after which
// LuminanceHistogram has the same bins again.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "three_pictures.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

/// The largest difference of displayed luminances at any pixel between any two of the units.
float largest_move(const ToneMapper& mapper, const Image<XYZ>& scene) {
    constexpr int kUnits = 24;
    std::vector<float> least(scene.pixels().size(), 1.0f), most(scene.pixels().size(), 0.0f);
    for (int k = 0; k < kUnits; ++k) {
        Image<XYZ> other = scene;
        for (XYZ& pixel : other.pixels()) pixel = std::exp2(static_cast<float>(k) / kUnits) * pixel;
        tone_map_into({mapper}, other.view(), other.view(), kWhite, 0);
        for (std::size_t i = 0; i < least.size(); ++i) {
            const float shown = std::min(other.pixels()[i].y, 1.0f);
            least[i] = std::min(least[i], shown);
            most[i] = std::max(most[i], shown);
        }
    }
    float largest = 0.0f;
    for (std::size_t i = 0; i < least.size(); ++i) largest = std::max(largest, most[i] - least[i]);
    return largest;
}

/// Those that do not need luminances in cd/m^2, with parameters that matter here.
std::vector<ToneMapper> relative_mappers() {
    std::vector<ToneMapper> mappers;
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        if (traits_of(mapper).unit != UnitOfLuminance::absolute) mappers.emplace_back(mapper);
    });
    for (const char* other : {"histogram:contrast=5", "histogram:contrast=20", "histogram:contrast=1000",
                              "reinhard-global:key=auto,white=auto", "reinhard-global:white=max",
                              "reinhard-local:key=auto", "durand:contrast=5"}) {
        mappers.push_back(parse_named<ToneMapper>(other, "tonemap"));
    }
    return mappers;
}

class UnitOfLuminanceTest : public testing::TestWithParam<ToneMapper> {};

// The three pictures have no such edges: they stay within 3/255. Small crops of them may reach 4/255.
TEST_P(UnitOfLuminanceTest, MovesNoPixelByMoreThanItSays) {
    // An automatic white is a ratio of both ends of the range, and squared.
    const bool is_ratio = GetParam() == parse_named<ToneMapper>("reinhard-global:key=auto,white=auto", "tonemap");
    const float stated = traits_of(GetParam()).unit == UnitOfLuminance::cancels ? 0.1f : is_ratio ? 6.0f : 3.0f;
    for (const TestPicture& picture : three_pictures()) {
        const float found = 255.0f * largest_move(GetParam(), picture.scene);
        std::cout << picture.name << ": at most " << found << "/255\n";
        EXPECT_LE(found, stated) << to_text(GetParam()) << ", " << picture.name;
    }
}

/// Two to nine luminances within six decades, each in many pixels, with noise that lies within one bin or across two:
/// most is trimmed here.
Image<XYZ> flat_areas(unsigned seed, float noise) {
    Pcg32 random(seed);
    std::vector<float> luminances(2 + random.next() % 8);
    for (float& luminance : luminances) luminance = std::pow(10.0f, 6.0f * random.next_float() - 3.0f);
    Image<XYZ> scene(80, 80);
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
        const float here = luminances[i / 16 % luminances.size()] * (1.0f + noise * (random.next_float() - 0.5f));
        scene.pixels()[i] = here * kWhite;
    }
    return scene;
}

TEST_P(UnitOfLuminanceTest, MovesNoPixelOfFlatAreasByMoreThanItSays) {
    const float stated = traits_of(GetParam()).unit == UnitOfLuminance::cancels ? 0.1f : 4.0f;
    for (unsigned seed = 0; seed < 9; ++seed) {
        const float noise = 0.015f * static_cast<float>(seed % 3);
        EXPECT_LE(255.0f * largest_move(GetParam(), flat_areas(seed, noise)), stated) << to_text(GetParam()) << seed;
    }
}

// With a key and a white that are given, they do not look at the range.
TEST(UnitOfLuminance, CancelsInPhotographicReproductionWithAKey) {
    for (const TestPicture& picture : three_pictures()) {
        for (const char* text : {"reinhard-global:key=0.18,white=inf", "reinhard-global:key=0.5,white=3"}) {
            EXPECT_LE(255.0f * largest_move(parse_named<ToneMapper>(text, "tonemap"), picture.scene), 0.1f) << text;
        }
        EXPECT_LE(255.0f * largest_move(ReinhardLocal{}, picture.scene), 0.1f) << picture.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Variant, UnitOfLuminanceTest, testing::ValuesIn(relative_mappers()), [](const auto& instance) {
    std::string name = to_text(instance.param);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return std::to_string(instance.index) + "_" + name;
});

}  // namespace
}  // namespace emulsion
