// PreparedToneMapping by the twins in double precision.

#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "core/random.h"
#include "tonemap/single_precision.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {
namespace {

constexpr XYZ kWhite{0.95f, 1.0f, 1.09f};
constexpr XYZd kWhiteD{kWhite.x, kWhite.y, kWhite.z};

Image<XYZ> picture(float brightness) {
    Image<XYZ> image(24, 16);
    Pcg32 random(3);
    for (XYZ& pixel : image.pixels()) {
        const float luminance = brightness * (0.01f + random.next_float() * random.next_float());
        pixel = {0.9f * luminance, luminance, 1.2f * luminance};
    }
    return image;
}

Image<XYZ> pixels_of(const PreparedToneMapping& map, int width, int height) {
    Image<XYZ> display(width, height);
    for (int y = 0; y < height; ++y) {
        // By the stretch, as later stages ask for them.
        map(y, 0, display.row(y).first(7));
        map(y, 7, display.row(y).subspan(7));
    }
    return display;
}

TEST(ReferenceMapping, HasThePixelsOfTheTwin) {
    const Image<XYZ> scene = picture(300.0f);
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        const ToneMapping mapping{mapper};
        const PreparedToneMapping map = PreparedToneMapping::reference(mapping, scene.view(), kWhite);
        EXPECT_TRUE(pixels_of(map, 24, 16) == in_single_precision(tone_map_reference(mapping, scene.view(), kWhiteD)))
            << mapper.kName;
        EXPECT_EQ(map.statistics().counts.positive, 24 * 16) << mapper.kName;
    });
}

TEST(ReferenceMapping, AsOtherIsTheTwinOfTheFastOne) {
    const Image<XYZ> scene = picture(900.0f), other = picture(300.0f), black(24, 16);
    for_each_alternative<ToneMapper>([&](const auto& mapper) {
        const ToneMapping mapping{mapper};
        const auto as_other = [&](const Image<XYZ>& a, const Image<XYZ>& b) {
            return tone_map_reference_as_other(mapping, a.view(), b.view(), kWhiteD);
        };
        EXPECT_TRUE(as_other(scene, scene) == tone_map_reference(mapping, scene.view(), kWhiteD)) << mapper.kName;
        EXPECT_TRUE(as_other(scene, black) == tone_map_reference(mapping, scene.view(), kWhiteD)) << mapper.kName;
        EXPECT_EQ(as_other(black, scene)(3, 3).y, 0.0) << mapper.kName;
        if (is_local(own_adaptation(mapper))) return;  // single pixels may differ by much there
        const Image<XYZ> fast =
            pixels_of(PreparedToneMapping::as_other(mapping, scene.view(), other.view(), kWhite, 1), 24, 16);
        const Image<XYZ> exact =
            pixels_of(PreparedToneMapping::reference_as_other(mapping, scene.view(), other.view(), kWhite), 24, 16);
        for (std::size_t i = 0; i < exact.pixels().size(); ++i) {
            // What tone_map_reference() states, where a curve has a corner.
            EXPECT_NEAR(fast.pixels()[i].y, exact.pixels()[i].y, 4e-3f * exact.pixels()[i].y) << mapper.kName;
        }
    });
}

TEST(ReferenceMapping, RefusesWhatTheFastOneDoes) {
    const Image<XYZ> scene = picture(1.0f);
    EXPECT_THROW((void)PreparedToneMapping::reference({ReinhardGlobal{-1.0f}}, scene.view(), kWhite),
                 std::invalid_argument);
    EXPECT_THROW((void)PreparedToneMapping::reference({}, Image<XYZ>().view(), kWhite), std::invalid_argument);
    EXPECT_THROW((void)PreparedToneMapping::reference_as_other({}, scene.view(), Image<XYZ>(24, 15).view(), kWhite),
                 std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
