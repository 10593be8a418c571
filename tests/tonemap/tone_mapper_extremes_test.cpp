// Unusual pictures and parameters, for every alternative of the variant.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include "core/random.h"
#include "every_tone_mapper.h"
#include "test_pictures.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

class EveryToneMapperAt : public EveryToneMapper {};

// As a filtered or interpolated picture has them.
TEST_P(EveryToneMapperAt, ThousandthOfNegativesLeavesTheOthers) {
    const Image<XYZ> clean = scene_for(GetParam(), 100, 100, 14);
    const Image<XYZ> clean_mapped = map(clean);
    Image<XYZ> scene = clean;
    Pcg32 random(15);
    for (int i = 0; i < 10; ++i)
        scene.pixels()[random.next() % 10000] = {-0.1f, -0.1f * random.next_float() - 1e-6f, 0.2f};
    const ToneMapResult result = tone_map({GetParam()}, scene.view(), kWhite, 1);
    EXPECT_EQ(result.statistics.counts.negative, 10);
    const float tolerance = 2.0f / 255.0f;
    for (std::size_t i = 0; i < clean.pixels().size(); ++i) {
        if (scene.pixels()[i].y < 0.0f) {
            EXPECT_EQ(result.image.pixels()[i], XYZ{});
        } else {
            EXPECT_NEAR(shown(result.image.pixels()[i]), shown(clean_mapped.pixels()[i]), tolerance) << i;
        }
    }
}

// Also where all that is next to it lies to one side.
TEST_P(EveryToneMapperAt, BadPixelAtTheEdgeLeavesTheOthers) {
    const Image<XYZ> clean = scene_for(GetParam(), 64, 64, 10), clean_mapped = map(clean);
    const float tolerance = most_move(GetParam());
    for (const auto& [bad_x, bad_y] : {std::pair{63, 14}, {63, 40}, {0, 33}, {20, 63}, {45, 0}}) {
        Image<XYZ> scene = clean;
        scene(bad_x, bad_y) = grey(std::numeric_limits<float>::quiet_NaN());
        Image<XYZ> mapped = map(scene);
        EXPECT_EQ(mapped(bad_x, bad_y), XYZ{});
        mapped(bad_x, bad_y) = clean_mapped(bad_x, bad_y);
        for (std::size_t i = 0; i < clean.pixels().size(); ++i) {
            EXPECT_NEAR(shown(mapped.pixels()[i]), shown(clean_mapped.pixels()[i]), tolerance) << i;
        }
    }
}

TEST_P(EveryToneMapperAt, RangeOf60DecadesIsDefined) {
    Pcg32 random(16);
    Image<XYZ> scene(97, 101);
    for (XYZ& pixel : scene.pixels()) pixel = grey(std::pow(10.0f, 60.0f * random.next_float() - 30.0f));
    scene(0, 0) = grey(1e-30f);
    scene(96, 100) = grey(1e30f);
    expect_twin(GetParam(), scene);
    const Image<XYZ> mapped = map(scene);
    EXPECT_GT(mapped(96, 100).y, 0.5f);
}

TEST_P(EveryToneMapperAt, DenormalsAreLuminancesToo) {
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

// As long as the darkest pixel, of 3e-3 here, keeps so many steps that rounding to them does not show.
TEST_P(EveryToneMapperAt, PictureInDenormalsIsThatOfItsUnit) {
    if (traits_of(GetParam()).unit == UnitOfLuminance::absolute) return;
    const Image<XYZ> scene = smooth_scene(61, 67, 9), mapped = map(scene);
    for (const float factor : {1e-36f, 1e-37f, 1e-38f, 1e-39f, 1e-40f, 1e-41f}) {
        Image<XYZ> other = scene;
        for (XYZ& pixel : other.pixels()) pixel = factor * pixel;
        EXPECT_LE(differences(mapped, map(other)).first, 4.0f / 255.0f) << factor;
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

TEST_P(EveryToneMapperAt, TurnsAndMirrorsWithThePicture) {
    // One adaptation differs by the order of its sum only, neighbourhoods by the order of their filters, too.
    const auto expect_same = [](int width, int height, float tolerance) {
        const Image<XYZ> scene = scene_for(GetParam(), width, height, 18);
        const Image<XYZ> mapped = map(scene);
        EXPECT_LE(differences(turned(mapped), map(turned(scene))).first, tolerance);
        EXPECT_LE(differences(mirrored(mapped), map(mirrored(scene))).first, tolerance);
    };
    const float tolerance = is_local(GetParam()) ? 1e-4f : 1e-6f;
    expect_same(96, 64, tolerance);
    expect_same(83, 59, tolerance);
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

/// One in four is a word, where there are words.
template <class T, class M>
void draw(const Parameter<T>& parameter, Pcg32& random, M& value) {
    if (parameter.special.empty() || random.next() % 4 != 0) return draw(parameter.range, random, value);
    value = static_cast<M>(parameter.special[random.next() % parameter.special.size()].value);
}

TEST_P(EveryToneMapperAt, AgreesWithItsTwinWithAnyParameters) {
    Pcg32 random(19);
    const Image<XYZ> scene = random_scene(16, 16, 20);
    for (int i = 0; i < 300; ++i) {
        ToneMapper mapper = GetParam();
        std::visit(
            [&]<class T>(T& chosen) {
                for (const Parameter<T>& parameter : parameters_of<T>()) {
                    std::visit([&](auto member) { draw(parameter, random, chosen.*member); }, parameter.member);
                }
            },
            mapper);
        expect_twin(mapper, scene);
    }
}

TEST_P(EveryToneMapperAt, AgreesWithItsTwinUnderEveryGlobalAdaptation) {
    Image<XYZ> scene = random_scene(37, 41, 21);
    scene(3, 3) = grey(std::numeric_limits<float>::quiet_NaN());
    for_each_alternative<Adaptation>([&](const auto& adaptation) {
        const ToneMapping mapping{GetParam(), adaptation};
        const SceneLuminance luminance = SceneLuminance(scene.view(), 1);
        if (adapt(adaptation, scene.view(), luminance, 1).local.width() > 0) return;
        const Image<XYZ> fast = tone_map(mapping, scene.view(), kWhite, 0).image;
        const Image<XYZd> exact = tone_map_reference(mapping, scene.view(), kWhiteD);
        for (std::size_t i = 0; i < fast.pixels().size(); ++i) {
            expect_close(fast.pixels()[i], exact.pixels()[i], to_text(Adaptation(adaptation)));
        }
    });
}

// Pictures of so small a range that one other pixel could be all of it.
TEST_P(EveryToneMapperAt, OnePixelDoesNotDecideAboutAnEvenPicture) {
    for (const float slope : {0.0f, 1e-5f, 5e-3f}) {
        Image<XYZ> clean(100, 100);
        for (int x = 0; x < 100; ++x) {
            for (int y = 0; y < 100; ++y) clean(x, y) = grey(20.0f * (1.0f + slope * static_cast<float>(x)));
        }
        const Image<XYZ> before = map(clean);
        for (const float value : {kNan, kInf, -1.0f, 1e30f, 1e-30f, 30.001f, 0.01f}) {
            const bool darkens = traits_of(GetParam()).outliers == OutlierEffect::darkens_all;
            if (darkens && value > 20.0f) continue;
            Image<XYZ> scene = clean;
            scene(50, 50) = grey(value);
            const Image<XYZ> after = map(scene);
            // What is good and no outlier is a part of the picture, and has a neighbourhood where there are any.
            const bool is_seen = is_local(GetParam()) && value > 0.0f && value < 1e30f;
            const int left_out = is_seen ? 8 : 0;
            for (int y = 0; y < 100; ++y) {
                for (int x = 0; x < 100; ++x) {
                    if (std::max(std::abs(x - 50), std::abs(y - 50)) <= left_out) continue;
                    ASSERT_NEAR(shown(after(x, y)), shown(before(x, y)), 2.0f / 255.0f) << value << ' ' << slope;
                }
            }
        }
    }
}

TEST_P(EveryToneMapperAt, OnePixelDoesNotDecideUnderAnyGlobalAdaptation) {
    const Image<XYZ> clean = smooth_scene(64, 64, 10);
    for_each_alternative<Adaptation>([&](const auto& adaptation) {
        if (is_local(Adaptation(adaptation))) return;
        const ToneMapping mapping{GetParam(), Adaptation(adaptation)};
        const Image<XYZ> before = tone_map(mapping, clean.view(), kWhite, 1).image;
        for (const float value : {1e30f, 1e-30f}) {
            if (traits_of(GetParam()).outliers == OutlierEffect::darkens_all && value > 1.0f) continue;
            Image<XYZ> scene = clean;
            scene(31, 32) = grey(value);
            const Image<XYZ> after = tone_map(mapping, scene.view(), kWhite, 1).image;
            for (std::size_t i = 0; i < clean.pixels().size(); ++i) {
                if (clean.pixels()[i] != scene.pixels()[i]) continue;
                ASSERT_NEAR(shown(after.pixels()[i]), shown(before.pixels()[i]), 2.0f / 255.0f)
                    << to_text(*mapping.adaptation) << ' ' << value;
            }
        }
    });
}

// An outlier is as good as no pixel to those that are far from it, in small pictures, too, where one pixel in hundreds
// would move the unit that neighbourhoods are relative to.
TEST_P(EveryToneMapperAt, OutlierIsNotSeenFromFarUnderAnyLocalAdaptation) {
    if (traits_of(GetParam()).outliers == OutlierEffect::darkens_all) return;
    for (const auto& [width, height] : {std::pair{20, 16}, {128, 1}}) {
        Image<XYZ> scene = smooth_scene(width, height, 10);
        const int outlier_x = width / 4, outlier_y = height / 2;
        for_each_alternative<Adaptation>([&](const auto& adaptation) {
            if (!is_local(Adaptation(adaptation))) return;
            const ToneMapping mapping{GetParam(), Adaptation(adaptation)};
            scene(outlier_x, outlier_y) = grey(kNan);
            const Image<XYZ> without = tone_map(mapping, scene.view(), kWhite, 1).image;
            scene(outlier_x, outlier_y) = grey(1e30f);
            const Image<XYZ> with = tone_map(mapping, scene.view(), kWhite, 1).image;
            for (int y = 0; y < scene.height(); ++y) {
                for (int x = outlier_x + 9; x < scene.width(); ++x) {
                    ASSERT_NEAR(shown(with(x, y)), shown(without(x, y)), 1.0f / 255.0f) << to_text(*mapping.adaptation);
                }
            }
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Extremes, EveryToneMapperAt, testing::ValuesIn(all_mappers()), mapper_name);

}  // namespace
}  // namespace emulsion
