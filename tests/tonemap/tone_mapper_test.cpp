// Properties that every operator has: each test runs for every alternative of the variant.

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
#include "test_pictures.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};
constexpr XYZd kWhiteD{0.95, 1.0, 1.09};

/// Every operator with its defaults.
std::vector<ToneMapper> all_mappers() {
    std::vector<ToneMapper> mappers;
    for_each_alternative<ToneMapper>([&](const auto& mapper) { mappers.emplace_back(mapper); });
    return mappers;
}

class EveryToneMapper : public testing::TestWithParam<ToneMapper> {
  protected:
    [[nodiscard]] static Image<XYZ> map(const Image<XYZ>& scene, int threads = 1) {
        return tone_map({GetParam()}, scene.view(), kWhite, threads).image;
    }
};

bool is_sound(const XYZ& p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && p.y >= 0.0f;
}

/// What a display makes of it.
float shown(const XYZ& pixel) noexcept { return std::min(pixel.y, 1.0f); }

void expect_sound(const Image<XYZ>& image) {
    EXPECT_TRUE(std::all_of(image.pixels().begin(), image.pixels().end(), is_sound));
}

/// |fast - exact| <= 2e-4 |exact| + 1e-37 in each component: the stated tolerance.
void expect_close(const XYZ& fast, const XYZd& exact, const std::string& where) {
    const auto close = [](float a, double b) { return std::abs(a - b) <= 2e-4 * std::abs(b) + 1e-37; };
    EXPECT_TRUE(close(fast.x, exact.x) && close(fast.y, exact.y) && close(fast.z, exact.z))
        << where << ": " << fast.x << " " << fast.y << " " << fast.z << ", exactly " << exact.x << " " << exact.y << " "
        << exact.z;
}

void expect_twin(const ToneMapper& mapper, const Image<XYZ>& scene) {
    const Image<XYZ> fast = tone_map({mapper}, scene.view(), kWhite, 0).image;
    const Image<XYZd> exact = tone_map_reference({mapper}, scene.view(), kWhiteD);
    expect_sound(fast);
    for (int y = 0; y < scene.height(); ++y) {
        for (int x = 0; x < scene.width(); ++x) {
            expect_close(fast(x, y), exact(x, y),
                         to_text(mapper) + " at " + std::to_string(x) + ", " + std::to_string(y));
            if (testing::Test::HasFailure()) return;
        }
    }
}

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
    EXPECT_LE(mapped(2, 2).y, 1.0f);
    EXPECT_EQ(mapped(0, 0), XYZ{});
}

TEST_P(EveryToneMapper, KeepsChromaticity) {
    const Image<XYZ> scene = random_scene(64, 64, 8);
    const Image<XYZ> mapped = map(scene);
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
        const XYZ before = scene.pixels()[i], after = mapped.pixels()[i];
        EXPECT_NEAR(after.x / after.y, before.x / before.y, 1e-6f);
        EXPECT_NEAR(after.z / after.y, before.z / before.y, 1e-6f);
    }
}

// The twin for any two pixels; the fast one to the tolerance of its table. 12 decades, those past the robust ends too.
TEST_P(EveryToneMapper, IsMonotone) {
    if (traits_of(GetParam()).monotone != Monotone::everywhere) GTEST_SKIP() << "claims it for one adaptation only";
    const Image<XYZ> ramp = ramp_of_greys(1e-6, 1e6, 20000);
    const Image<XYZ> mapped = map(ramp);
    const Image<XYZd> exact = tone_map_reference({GetParam()}, ramp.view(), kWhiteD);
    for (int x = 1; x < ramp.width(); ++x) {
        ASSERT_GE(mapped(x, 0).y, mapped(x - 1, 0).y * (1.0f - 2e-4f)) << x;
        ASSERT_GE(exact(x, 0).y, exact(x - 1, 0).y * (1.0 - 1e-13)) << x;
    }
}

/// Largest difference of what a display shows, and largest relative difference, between two maps.
std::pair<float, float> differences(const Image<XYZ>& a, const Image<XYZ>& b) {
    float of_shown = 0.0f, relative = 0.0f;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const XYZ before = a.pixels()[i], after = b.pixels()[i];
        of_shown = std::max(of_shown, std::abs(shown(after) - shown(before)));
        if (before.y != after.y) relative = std::max(relative, std::abs(after.y - before.y) / before.y);
    }
    return {of_shown, relative};
}

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
            EXPECT_LE(of_shown, 3.0f / 255.0f) << factor;
        }
    }
}

// The picture as before, to the bit, but for the log-average of one pixel less.
TEST_P(EveryToneMapper, BadPixelsBecomeDefinedAndLeaveTheOthers) {
    const Image<XYZ> clean = random_scene(64, 64, 10);
    const Image<XYZ> clean_mapped = map(clean);
    Image<XYZ> scene = clean;
    scene(3, 2) = {1.0f, kNan, 1.0f};
    scene(4, 2) = {kNan, 1.0f, 1.0f};
    scene(5, 2) = {1.0f, -1.0f, 1.0f};
    scene(6, 2) = {1.0f, -kInf, 1.0f};
    scene(7, 2) = {kInf, kInf, kInf};
    scene(8, 2) = {-kInf, 1.0f, 1.0f};
    const ToneMapResult result = tone_map({GetParam()}, scene.view(), kWhite, 1);
    EXPECT_EQ(result.statistics.counts, (PixelCounts{64 * 64 - 6, 0, 2, 2, 2}));
    EXPECT_EQ(result.statistics.first_bad_px, std::make_pair(3, 2));
    for (int x = 3; x <= 6; ++x) EXPECT_EQ(result.image(x, 2), XYZ{}) << x;
    for (int x = 7; x <= 8; ++x) EXPECT_EQ(result.image(x, 2), kWhite) << x;
    for (int y = 3; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            EXPECT_NEAR(shown(result.image(x, y)), shown(clean_mapped(x, y)), 2.0f / 255.0f) << x << ", " << y;
        }
    }
}

TEST_P(EveryToneMapper, OutlierDoesToTheOthersWhatItSays) {
    const Image<XYZ> clean = random_scene(64, 64, 10);
    const Image<XYZ> clean_mapped = map(clean);
    Image<XYZ> scene = clean;
    scene(20, 30) = grey(1e30f);
    const Image<XYZ> mapped = map(scene);
    bool stays = true, all_dark = true;
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            // What is next to it is averaged with what was there before.
            if (std::max(std::abs(x - 20), std::abs(y - 30)) <= 8) continue;
            stays = stays && std::abs(shown(mapped(x, y)) - shown(clean_mapped(x, y))) <= 2.0f / 255.0f;
            all_dark = all_dark && shown(mapped(x, y)) < 1e-6f;
        }
    }
    const bool darkens = traits_of(GetParam()).outliers == OutlierEffect::darkens_all;
    EXPECT_EQ(all_dark, darkens);
    EXPECT_EQ(stays, !darkens);
}

// As a filtered or interpolated picture has them.
TEST_P(EveryToneMapper, ThousandthOfNegativesLeavesTheOthers) {
    const Image<XYZ> clean = random_scene(100, 100, 14);
    const Image<XYZ> clean_mapped = map(clean);
    Image<XYZ> scene = clean;
    Pcg32 random(15);
    for (int i = 0; i < 10; ++i)
        scene.pixels()[random.next() % 10000] = {-0.1f, -0.1f * random.next_float() - 1e-6f, 0.2f};
    const ToneMapResult result = tone_map({GetParam()}, scene.view(), kWhite, 1);
    EXPECT_EQ(result.statistics.counts.negative, 10);
    for (std::size_t i = 0; i < clean.pixels().size(); ++i) {
        if (scene.pixels()[i].y < 0.0f) {
            EXPECT_EQ(result.image.pixels()[i], XYZ{});
        } else {
            EXPECT_NEAR(shown(result.image.pixels()[i]), shown(clean_mapped.pixels()[i]), 2.0f / 255.0f) << i;
        }
    }
}

TEST_P(EveryToneMapper, RangeOf60DecadesIsDefined) {
    Pcg32 random(16);
    Image<XYZ> scene(97, 101);
    for (XYZ& pixel : scene.pixels()) pixel = grey(std::pow(10.0f, 60.0f * random.next_float() - 30.0f));
    scene(0, 0) = grey(1e-30f);
    scene(96, 100) = grey(1e30f);
    expect_twin(GetParam(), scene);
    const Image<XYZ> mapped = map(scene);
    EXPECT_GT(mapped(96, 100).y, 0.5f);
}

TEST_P(EveryToneMapper, DenormalsAreLuminancesToo) {
    Pcg32 random(17);
    Image<XYZ> scene(31, 29);
    for (XYZ& pixel : scene.pixels()) pixel = grey(std::bit_cast<float>(1u + random.next() % 0x7fffffu));
    expect_twin(GetParam(), scene);
    for (XYZ& pixel : scene.pixels()) pixel = grey(std::numeric_limits<float>::denorm_min());
    expect_twin(GetParam(), scene);
    const Image<XYZ> mapped = map(scene);
    EXPECT_EQ(mapped(0, 0), mapped(30, 28));
    if (traits_of(GetParam()).unit != UnitOfLuminance::absolute) {
        EXPECT_GT(mapped(0, 0).y, 0.02f);
    }
}

/// (x, y) of the picture that is turned by a quarter is (y, width - 1 - x) of the original.
Image<XYZ> turned(const Image<XYZ>& image) {
    Image<XYZ> result(image.height(), image.width());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) result(y, image.width() - 1 - x) = image(x, y);
    }
    return result;
}

Image<XYZ> mirrored(const Image<XYZ>& image) {
    Image<XYZ> result(image.width(), image.height());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) result(image.width() - 1 - x, y) = image(x, y);
    }
    return result;
}

TEST_P(EveryToneMapper, TurnsAndMirrorsWithThePicture) {
    const Image<XYZ> scene = random_scene(83, 59, 18);
    const Image<XYZ> mapped = map(scene);
    // One adaptation differs by the order of its sum only; neighbourhoods by the order of their filters too.
    const float tolerance = traits_of(GetParam()).monotone == Monotone::everywhere ? 1e-6f : 1.0f / 255.0f;
    EXPECT_LE(differences(turned(mapped), map(turned(scene))).first, tolerance);
    EXPECT_LE(differences(mirrored(mapped), map(mirrored(scene))).first, tolerance);
}

void draw(const ParameterRange& range, Pcg32& random, float& value) {
    do value = std::bit_cast<float>(random.next());
    while (!range.contains(value));
}
void draw(const ParameterRange& range, Pcg32& random, double& value) {
    float drawn = 0.0f;
    draw(range, random, drawn);
    value = drawn;
}
void draw(const ParameterRange& range, Pcg32& random, int& value) {
    const double most = std::min(range.max, range.min + 1000.0);
    value = static_cast<int>(range.min + double{random.next_float()} * (most - range.min));
}

TEST_P(EveryToneMapper, IsSoundWithAnyParameters) {
    Pcg32 random(19);
    const Image<XYZ> scene = random_scene(16, 16, 20);
    for (int i = 0; i < 300; ++i) {
        ToneMapper mapper = GetParam();
        std::visit(
            [&]<class T>(T& chosen) {
                for (const Parameter<T>& parameter : parameters_of<T>()) {
                    std::visit([&](auto member) { draw(parameter.range, random, chosen.*member); }, parameter.member);
                }
            },
            mapper);
        const Image<XYZ> mapped = tone_map({mapper}, scene.view(), kWhite, 1).image;
        ASSERT_TRUE(std::all_of(mapped.pixels().begin(), mapped.pixels().end(), is_sound)) << to_text(mapper);
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
    const Image<XYZ> half_mapped = map(half), mapped = map(scene);
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 64; ++x) EXPECT_EQ(mapped(x, y), half_mapped(x, y));
    }
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

INSTANTIATE_TEST_SUITE_P(Variant, EveryToneMapper, testing::ValuesIn(all_mappers()), [](const auto& instance) {
    std::string name = to_text(ToneMapper(instance.param));
    name.resize(std::min(name.size(), name.find(':')));
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

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
