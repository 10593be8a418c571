#include "tonemap/exposure.h"

#include <gtest/gtest.h>

#include "prepared_operator.h"
#include "test_pictures.h"

namespace emulsion {
namespace {

TEST(Exposure, MeteredLuminanceBecomesMiddleGrey) {
    const PreparedOperator displayed(Exposure{}, row_of_greys({1.0f, 40.0f}), 40.0);
    EXPECT_DOUBLE_EQ(displayed(40.0), 0.18);
    EXPECT_DOUBLE_EQ(displayed(20.0), 0.09);
    EXPECT_DOUBLE_EQ(displayed(400.0), 1.8);
}

TEST(Exposure, EachStopIsTwiceAsBright) {
    const Image<XYZ> scene = row_of_greys({1.0f, 40.0f});
    EXPECT_DOUBLE_EQ(PreparedOperator(Exposure{1.0f}, scene, 40.0)(40.0), 0.36);
    EXPECT_DOUBLE_EQ(PreparedOperator(Exposure{-2.0f}, scene, 40.0)(40.0), 0.045);
    EXPECT_NEAR(PreparedOperator(Exposure{1.0f / 3.0f}, scene, 40.0)(40.0), 0.18 * 1.259921, 1e-7);
}

// The log-average of 4 and 100 is 20.
TEST(Exposure, MetersThePictureUnlessToldOtherwise) {
    const Image<XYZ> scene = row_of_greys({4.0f, 100.0f});
    const XYZ white{0.95f, 1.0f, 1.09f};
    EXPECT_FLOAT_EQ(tone_map({Exposure{}}, scene.view(), white, 1).image(0, 0).y, 0.036f);
    const ToneMapping spot{Exposure{}, SpotAdaptation{0.75f, 0.5f, 0.0f}};
    EXPECT_FLOAT_EQ(tone_map(spot, scene.view(), white, 1).image(1, 0).y, 0.18f);
}

}  // namespace
}  // namespace emulsion
