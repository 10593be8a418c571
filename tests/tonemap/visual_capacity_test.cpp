#include "tonemap/visual_capacity.h"

#include <cmath>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

const double kFirstBreak = std::pow(10.0, -2.465), kLastBreak = std::pow(10.0, 0.86);

TEST(VisualCapacity, HasTheUnroundedOffsets) {
    EXPECT_NEAR(visual_capacity(kFirstBreak), 2.483133, 5e-7);
    EXPECT_NEAR(visual_capacity(1.0), 16.577079, 5e-7);
    EXPECT_NEAR(visual_capacity(kLastBreak), 32.082655, 5e-7);
    EXPECT_EQ(visual_capacity(0.0), 0.0);
}

TEST(VisualCapacity, IsContinuousAndRises) {
    for (const double here : {kFirstBreak, 1.0, kLastBreak}) {
        EXPECT_NEAR(visual_capacity(here * (1.0 - 1e-12)), visual_capacity(here), 1e-9) << here;
    }
    double previous = -1.0;
    for (double luminance = 1e-8; luminance < 1e8; luminance *= 1.01) {
        EXPECT_GT(visual_capacity(luminance), previous) << luminance;
        previous = visual_capacity(luminance);
    }
}

// C' = 1 / TVI, log10 TVI = -2.86, log10 Y - 0.395, -0.395, log10 Y - 1.255.
TEST(VisualCapacity, RisesByOneForEachThreshold) {
    const auto slope = [](double y) {
        return (visual_capacity(1.0001 * y) - visual_capacity(0.9999 * y)) / (2e-4 * y);
    };
    EXPECT_NEAR(slope(0.001) * std::pow(10.0, -2.86), 1.0, 1e-6);
    EXPECT_NEAR(slope(0.1) * 0.1 * std::pow(10.0, -0.395), 1.0, 1e-6);
    EXPECT_NEAR(slope(3.0) * std::pow(10.0, -0.395), 1.0, 1e-6);
    EXPECT_NEAR(slope(1000.0) * 1000.0 * std::pow(10.0, -1.255), 1.0, 1e-6);
}

// With log10 it would jump from 8.58 to 16.56 at 1; as printed, by the digits that were rounded away.
TEST(VisualCapacity, PrintedConstantsMeetToTheirDigits) {
    const auto jump = [](double y) { return printed_visual_capacity(y) - printed_visual_capacity(y * (1.0 - 1e-12)); };
    EXPECT_NEAR(jump(0.0034), 2.4483 - 0.0034 / 0.0014, 1e-9);
    EXPECT_NEAR(jump(0.0034), 0.0197, 1e-4);
    EXPECT_NEAR(jump(1.0), 0.0, 1e-4);
    EXPECT_NEAR(jump(7.2444), 0.0, 1e-4);
    for (double luminance = 1e-4; luminance < 1e6; luminance *= 1.3) {
        EXPECT_NEAR(printed_visual_capacity(luminance) / visual_capacity(luminance), 1.0, 0.016) << luminance;
    }
}

}  // namespace
}  // namespace emulsion
