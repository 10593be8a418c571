// Two pictures by one tone curve.

#include <span>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "every_tone_mapper.h"

namespace emulsion {
namespace {

Image<XYZ> mapped(const PreparedToneMapping& map, int width, int height) {
    Image<XYZ> display(width, height);
    for (int y = 0; y < height; ++y) map(y, 0, display.row(y));
    return display;
}

Image<XYZ> mapped_as(const ToneMapping& mapping, const Image<XYZ>& scene, const Image<XYZ>& other) {
    return mapped(PreparedToneMapping::as_other(mapping, scene.view(), other.view(), kWhite, 1), scene.width(),
                  scene.height());
}

TEST(ToneMappingAsOther, AsItselfIsAsAlways) {
    for (const ToneMapper& mapper : all_mappers()) {
        const Image<XYZ> scene = scene_for(mapper, 61, 43, 3);
        EXPECT_EQ(mapped_as({mapper}, scene, scene), tone_map({mapper}, scene.view(), kWhite, 1).image)
            << to_text(mapper);
    }
}

// By its own statistics it would be the same picture.
TEST(ToneMappingAsOther, ABrighterPictureComesOutBrighter) {
    for (const ToneMapper& mapper : all_mappers()) {
        const ToneMapping mapping = with_global_adaptation(mapper);
        const Image<XYZ> scene = smooth_scene(61, 43, 4);
        Image<XYZ> brighter = scene;
        for (XYZ& pixel : brighter.pixels()) pixel = 1.5f * pixel;
        const Image<XYZ> before = mapped_as(mapping, scene, scene), after = mapped_as(mapping, brighter, scene);
        double sum_before = 0.0, sum_after = 0.0;
        for (const XYZ& pixel : before.pixels()) sum_before += pixel.y;
        for (const XYZ& pixel : after.pixels()) sum_after += pixel.y;
        EXPECT_GT(sum_after, 1.01 * sum_before) << to_text(mapper);
        expect_sound(after);
    }
    const Image<XYZ> scene = smooth_scene(16, 16, 4);
    Image<XYZ> twice = scene;
    for (XYZ& pixel : twice.pixels()) pixel = 2.0f * pixel;
    const Image<XYZ> before = mapped_as({Exposure{}}, scene, scene), after = mapped_as({Exposure{}}, twice, scene);
    for (std::size_t i = 0; i < before.pixels().size(); ++i) {
        EXPECT_FLOAT_EQ(after.pixels()[i].y, 2.0f * before.pixels()[i].y);
    }
}

TEST(ToneMappingAsOther, BlackPicturesAreBlackOrMappedByThemselves) {
    const Image<XYZ> scene = smooth_scene(16, 16, 5), black(16, 16);
    EXPECT_EQ(mapped_as({}, black, scene), black);
    EXPECT_EQ(mapped_as({}, scene, black), tone_map({}, scene.view(), kWhite, 1).image);
    EXPECT_THROW((void)PreparedToneMapping::as_other({}, scene.view(), Image<XYZ>(16, 15).view(), kWhite, 1),
                 std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
