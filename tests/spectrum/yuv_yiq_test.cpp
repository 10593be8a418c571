#include <cmath>

#include <gtest/gtest.h>

#include "spectrum/yiq.h"
#include "spectrum/yuv.h"

namespace emulsion {
namespace {

TEST(Yuv, IsScaledNotBareDifferences) {
    const Yuv blue = yuv_from_rgb({0.0, 0.0, 1.0}), red = yuv_from_rgb({1.0, 0.0, 0.0});
    EXPECT_NEAR(blue.luma, 0.114, 1e-15);
    EXPECT_NEAR(blue.u, 0.492 * 0.886, 1e-15);
    EXPECT_NEAR(blue.v, 0.877 * -0.114, 1e-15);
    EXPECT_NEAR(red.luma, 0.299, 1e-15);
    EXPECT_NEAR(red.u, 0.492 * -0.299, 1e-15);
    EXPECT_NEAR(red.v, 0.877 * 0.701, 1e-15);
}

TEST(YuvAndYiq, OfGreysAreGrey) {
    for (const double grey : {0.0, 0.25, 1.0, 2.0}) {
        const Yuv yuv = yuv_from_rgb({grey, grey, grey});
        const Yiq yiq = yiq_from_rgb({grey, grey, grey});
        EXPECT_NEAR(yuv.luma, grey, 1e-15);
        EXPECT_NEAR(std::hypot(yuv.u, yuv.v), 0.0, 1e-15);
        EXPECT_NEAR(yiq.luma, grey, 1e-15);
        EXPECT_NEAR(std::hypot(yiq.i, yiq.q), 0.0, 1e-15);
    }
}

// The matrix in print, to six decimals.
TEST(Yiq, HasThePrintedMatrix) {
    constexpr double kTolerance = 1e-6;
    const Yiq red = yiq_from_rgb({1.0, 0.0, 0.0}), green = yiq_from_rgb({0.0, 1.0, 0.0}),
              blue = yiq_from_rgb({0.0, 0.0, 1.0});
    EXPECT_NEAR(red.i, 0.595716, kTolerance);
    EXPECT_NEAR(green.i, -0.274453, kTolerance);
    EXPECT_NEAR(blue.i, -0.321263, kTolerance);
    EXPECT_NEAR(red.q, 0.211456, kTolerance);
    EXPECT_NEAR(green.q, -0.522591, kTolerance);
    EXPECT_NEAR(blue.q, 0.311135, kTolerance);
}

TEST(YuvAndYiq, TakeValuesOutsideTheCube) {
    const RGBd rgb = {-0.5, 1.5, 3.0};
    for (const RGBd& back : {rgb_from_yuv(yuv_from_rgb(rgb)), rgb_from_yiq(yiq_from_rgb(rgb))}) {
        EXPECT_NEAR(back.r, rgb.r, 2e-15);
        EXPECT_NEAR(back.g, rgb.g, 2e-15);
        EXPECT_NEAR(back.b, rgb.b, 2e-15);
    }
}

}  // namespace
}  // namespace emulsion
