#include "tonemap/histogram_adjustment.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"
#include "tonemap/detection_threshold.h"

namespace emulsion {
namespace {

SceneLuminance luminance_of(const Image<XYZ>& scene) { return SceneLuminance(scene.view(), 1); }

/// d ln(Ld) / d ln(Y).
double contrast(const PreparedOperator& displayed, double luminance) {
    return displayed.slope(luminance) / displayed.scale(luminance);
}

// By hand from the printed pieces: 10^-2.86; 0.385^2.18 - 2.86; 0.1 * 10^-0.395; 0.65^2.7 - 0.72; 10^(2 - 1.255).
TEST(DetectionThreshold, HasThePapersValues) {
    EXPECT_NEAR(std::log10(detection_threshold_cdm2(1e-6)), -2.86, 1e-12);
    EXPECT_NEAR(std::log10(detection_threshold_cdm2(1e-3)), -2.735174, 1e-6);
    EXPECT_NEAR(std::log10(detection_threshold_cdm2(0.1)), -1.395, 1e-12);
    EXPECT_NEAR(std::log10(detection_threshold_cdm2(1.0)), -0.407488, 1e-6);
    EXPECT_NEAR(std::log10(detection_threshold_cdm2(100.0)), 0.745, 1e-12);
    EXPECT_NEAR(std::log10(detection_threshold_cdm2(0.0)), -2.86, 1e-12);
}

TEST(DetectionThreshold, StepsAreThoseOfThePrintedDigits) {
    const auto step_at = [](double log_luminance) {
        const double luminance = std::pow(10.0, log_luminance);
        return detection_threshold_cdm2(luminance * (1.0 + 1e-9)) / detection_threshold_cdm2(luminance * (1.0 - 1e-9));
    };
    EXPECT_NEAR(step_at(-3.94), 1.0, 1e-4);
    EXPECT_NEAR(step_at(-1.44), 0.973, 1e-3);
    EXPECT_NEAR(step_at(-0.0184), 1.0, 1e-3);
    EXPECT_NEAR(step_at(1.9), 0.993, 1e-3);
}

// Six decades, evenly filled, on two: every contrast becomes a third.
TEST(HistogramAdjustment, EvenHistogramIsAPowerOfLuminance) {
    const PreparedOperator displayed(HistogramAdjustment{100.0f}, ramp_of_greys(1e-3, 1e3, 60000), 1.0);
    for (const double luminance : {2e-3, 1e-2, 1.0, 31.0, 900.0}) {
        EXPECT_NEAR(displayed(luminance), 0.01 * std::pow(luminance / 1e-3, 1.0 / 3.0), 0.01 * displayed(luminance));
    }
    EXPECT_NEAR(displayed(1e3), 1.0, 0.01);
    EXPECT_NEAR(displayed(1.014e-3), 0.01, 1e-4);  // a thousandth of the pixels are darker
}

TEST(HistogramAdjustment, RangeThatFitsIsLinear) {
    const PreparedOperator displayed(HistogramAdjustment{100.0f}, row_of_greys({2.0f, 3.0f, 150.0f}), 1.0);
    EXPECT_FALSE(displayed.reproduction.compression);
    EXPECT_DOUBLE_EQ(displayed(150.0), 1.0);
    EXPECT_DOUBLE_EQ(displayed(2.0), 2.0 / 150.0);
}

TEST(HistogramAdjustment, ConstantPictureIsWhite) {
    for (const float luminance : {1e-30f, 1.0f, 3.0f, 7.7f}) {
        EXPECT_DOUBLE_EQ(PreparedOperator(HistogramAdjustment{}, row_of_greys({luminance, luminance}), 1.0)(luminance),
                         1.0);
    }
}

// Between them there is nothing: both keep their own contrast, and the gap takes what is left of the display's range.
TEST(HistogramAdjustment, TwoLuminancesFarApartAreBothShown) {
    std::vector<float> luminances(1000, 1.1f);
    luminances.resize(2000, 1.1e6f);
    const PreparedOperator displayed(HistogramAdjustment{100.0f}, row_of_greys(luminances), 1.0);
    EXPECT_NEAR(displayed(1.1), 0.01, 1e-3);
    EXPECT_NEAR(displayed(1.1e6), 1.0, 0.05);
}

TEST(HistogramAdjustment, NowhereMoreContrastThanLinear) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        // Half of the pixels in a hundredth of the range.
        Image<XYZ> scene = random_scene(64, 64, seed);
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 64; ++x) scene(x, y) = grey(5.0f + 0.01f * static_cast<float>(x));
        }
        const PreparedOperator displayed(HistogramAdjustment{}, scene, 1.0);
        double steepest = 0.0;
        for (double luminance = 1e-5; luminance < 1e5; luminance *= 1.003) {
            const double here = contrast(displayed, luminance);
            EXPECT_GE(here, -1e-6);
            steepest = std::max(steepest, here);
        }
        EXPECT_LE(steepest, 1.005 + 1e-6);
        EXPECT_GE(steepest, 0.99);  // it is reached
    }
}

TEST(HistogramAdjustment, EndsHaveFiniteScales) {
    const PreparedOperator displayed(HistogramAdjustment{100.0f}, ramp_of_greys(1e-3, 1e3, 5000), 1.0);
    EXPECT_DOUBLE_EQ(displayed.scale(0.0), displayed.scale(1e-5));
    EXPECT_GT(displayed(1e30), displayed(1e3));
    EXPECT_TRUE(std::isfinite(displayed(1e38)));
}

// The curve's corners are at knots of the table that the fast path takes: as near as where a curve is smooth.
TEST(HistogramAdjustment, KnotsAreThoseOfTheHistogram) {
    const auto curve =
        adjusted_histogram(luminance_of(random_scene(64, 64, 3)), {1.0, 100.0}, [](double, double) { return 1.0; });
    ASSERT_TRUE(curve.has_value());
    for (const BrightnessCurve::Knot& knot : curve->knots()) {
        const double in_its_octave = std::ldexp(knot.luminance_cdm2, 5 - std::ilogb(knot.luminance_cdm2));
        EXPECT_NEAR(in_its_octave, std::round(in_its_octave), 1e-12);
    }
}

TEST(HistogramHuman, NoMoreIsVisibleThanInTheWorld) {
    const PreparedOperator displayed(HistogramHuman{}, ramp_of_greys(1e-4, 1e2, 20000), 0.1);
    for (double luminance = 1.02e-4; luminance < 1e2; luminance *= 1.01) {  // of the robust range
        const double shown = 100.0 * displayed(luminance);
        const double ceiling =
            (detection_threshold_cdm2(shown) / shown) / (detection_threshold_cdm2(luminance) / luminance);
        // A bin is up to 3.1 % wide; the ceiling is taken at its middle, and lies above by what a pass leaves
        // untrimmed.
        EXPECT_LE(contrast(displayed, luminance), 1.03 * std::min(1.0, ceiling)) << luminance;
    }
}

// Four decades: by day they fill the display; by starlight they are hardly seen.
TEST(HistogramHuman, DarkScenesComeOutDark) {
    const PreparedOperator day(HistogramHuman{}, ramp_of_greys(10.0, 1e5, 20000), 1e3);
    EXPECT_NEAR(day(1e5), 1.0, 0.01);
    EXPECT_NEAR(day(10.0), 0.01, 0.001);
    const PreparedOperator night(HistogramHuman{}, ramp_of_greys(1e-8, 1e-4, 20000), 1e-6);
    EXPECT_FALSE(night.reproduction.compression);
    EXPECT_LT(night(1e-4), 0.01);
    EXPECT_GT(night(1e-4), 0.0);
}

// T(50) = 10^(1.0730435^2.7 - 0.72) = 3.087946, T(3) = 10^(0.7688032^2.7 - 0.72) = 0.591154.
TEST(HistogramHuman, ConstantPictureIsLinearByThresholds) {
    const PreparedOperator displayed(HistogramHuman{}, row_of_greys({3.0f}), 3.0);
    EXPECT_NEAR(displayed(3.0), 0.03 * 3.087946 / 0.591154, 1e-6);
    const PreparedOperator bright(HistogramHuman{}, row_of_greys({3e4f}), 3e-4);
    EXPECT_DOUBLE_EQ(bright(3e4), 1.0);
}

}  // namespace
}  // namespace emulsion
