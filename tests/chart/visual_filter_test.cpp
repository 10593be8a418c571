#include "chart/visual_filter.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(FourierTransform, OfAWaveIsOneNumber) {
    constexpr int kCount = 64, kCycles = 5;
    std::vector<std::complex<double>> values;
    for (int i = 0; i < kCount; ++i) values.push_back(std::polar(1.0, 2.0 * std::numbers::pi * kCycles * i / kCount));
    fourier_transform(values);
    for (int i = 0; i < kCount; ++i) {
        EXPECT_NEAR(std::abs(values[static_cast<std::size_t>(i)] - (i == kCycles ? kCount : 0.0)), 0.0, 1e-11);
    }
}

TEST(ContrastSensitivity, IsLowPassAndContinuousAtThePeak) {
    EXPECT_EQ(contrast_sensitivity(0.0), 1.0);
    EXPECT_EQ(contrast_sensitivity(7.0), 1.0);
    double previous = 1.0;
    for (double f = 7.9; f < 60.0; f += 0.1) {
        EXPECT_LT(contrast_sensitivity(f), previous);
        EXPECT_NEAR(contrast_sensitivity(f), previous, 0.02);
        previous = contrast_sensitivity(f);
    }
    // 2.6 (0.0192 + 0.114 f) exp(-(0.114 f)^1.1) at 30 and at 7.8909, by hand.
    EXPECT_NEAR(contrast_sensitivity(30.0), 0.18698 / 0.98088, 1e-5);
}

TEST(VisibleRms, OfOneWaveIsItsRmsTimesTheSensitivity) {
    constexpr int kSide = 64;
    for (const int cycles : {0, 3, 10, 25}) {
        Image<double> wave(kSide, kSide);
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) wave(x, y) = 0.3 * std::cos(2.0 * std::numbers::pi * cycles * y / kSide);
        }
        const double rms = cycles == 0 ? 0.3 : 0.3 / std::numbers::sqrt2;
        EXPECT_NEAR(visible_rms(wave, 67.0), rms * contrast_sensitivity(67.0 * cycles / kSide), 1e-12) << cycles;
    }
}

TEST(VisibleRms, RefusesOtherSizes) {
    EXPECT_THROW((void)visible_rms(Image<double>(8, 16), 40.0), std::invalid_argument);
    EXPECT_THROW((void)visible_rms(Image<double>(12, 12), 40.0), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
