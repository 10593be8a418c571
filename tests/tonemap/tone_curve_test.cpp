#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "every_tone_mapper.h"

namespace emulsion {
namespace {

class ToneCurve : public EveryToneMapper {};

// From the darkest to the brightest pixel, and there what the picture has.
TEST_P(ToneCurve, IsWhatThePictureGets) {
    const Image<XYZ> scene = random_scene(40, 30, 21);
    const ToneMapping mapping = with_global_adaptation(GetParam());
    const std::vector<CurvePoint> curve = tone_curve(mapping, scene.view(), 2);
    const LuminanceStatistics statistics = luminance_statistics_reference(scene.view());
    ASSERT_GE(curve.size(), 2u);
    EXPECT_NEAR(curve.front().luminance_cdm2, statistics.min_positive_cdm2, 1e-12 * statistics.min_positive_cdm2);
    EXPECT_NEAR(curve.back().luminance_cdm2, statistics.max_cdm2, 1e-12 * statistics.max_cdm2);
    const double step = std::log2(curve[1].luminance_cdm2 / curve[0].luminance_cdm2);
    EXPECT_LE(step, 1.0 / 16.0 + 1e-12);
    const Image<XYZd> mapped = tone_map_reference(mapping, scene.view(), kWhiteD);
    for (std::size_t i = 0; i < scene.pixels().size(); ++i) {
        const double cdm2 = scene.pixels()[i].y;
        if (cdm2 != statistics.max_cdm2) continue;
        EXPECT_NEAR(curve.back().display_luminance, mapped.pixels()[i].y, 1e-9 * mapped.pixels()[i].y);
    }
}

TEST_P(ToneCurve, IsSoundUnderTheOperatorsOwnAdaptation) {
    for (const CurvePoint& point : tone_curve({GetParam()}, random_scene(40, 30, 22).view(), 1)) {
        EXPECT_TRUE(std::isfinite(point.display_luminance) && point.display_luminance >= 0.0) << point.luminance_cdm2;
    }
}

TEST_P(ToneCurve, IsOnePointForAConstantAndNoneForBlack) {
    Image<XYZ> scene(3, 2);
    EXPECT_TRUE(tone_curve({GetParam()}, scene.view(), 1).empty());
    for (XYZ& pixel : scene.pixels()) pixel = grey(5.0f);
    EXPECT_EQ(tone_curve({GetParam()}, scene.view(), 1).size(), 1u);
}

INSTANTIATE_TEST_SUITE_P(Curves, ToneCurve, testing::ValuesIn(all_mappers()), mapper_name);

}  // namespace
}  // namespace emulsion
