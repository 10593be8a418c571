#include "spectrum/reflectance_weights.h"

#include <numeric>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/daylight.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(ReflectanceWeights, AddUpToOne) {
    const ReflectanceRgb space = reflectance_rgb(rgb_space("sRGB"));
    for (const ReflectanceWeights* weights : {&space.xyz_weights, &space.rgb_weights}) {
        for (const auto& sum : weights->sum) {
            EXPECT_EQ(sum.size(), kWholeNanometres);
            EXPECT_NEAR(std::accumulate(sum.begin(), sum.end(), 0.0), 1.0, 1e-13);
        }
    }
}

TEST(ReflectanceWeights, AreTheExactIntegralForKnotsAtWholeNanometres) {
    const PiecewiseLinearSpectrum d65 = illuminant_of(rgb_space("sRGB"));
    const Spectrum patch = tabulated_spectrum("colorchecker_reflectance", "orange");
    Spectrum held = patch;
    std::get<PiecewiseLinearSpectrum>(held).extrapolation = Extrapolation::hold;
    const auto sums = weighted_sums(reflectance_weights(d65), held);
    const XYZd exact = xyz_of_reflectance(held, d65), white = xyz_of_reflectance(ConstantSpectrum{1.0}, d65);
    EXPECT_NEAR(sums[0], exact.x / white.x, 1e-12);
    EXPECT_NEAR(sums[1], exact.y / white.y, 1e-12);
    EXPECT_NEAR(sums[2], exact.z / white.z, 1e-12);
}

TEST(ReflectanceWeights, NeedLight) {
    EXPECT_THAT([] { (void)reflectance_weights(ConstantSpectrum{0.0}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("illuminant")));
}

TEST(Illuminant, IsTabulatedD65OrDaylightOfTheWhite) {
    EXPECT_EQ(illuminant_of(rgb_space("Rec2020")), tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65"));
    for (const char* name : {"ACEScg_AP1", "ROMM_ProPhoto", "NTSC_1953"}) {
        const RgbSpace& space = rgb_space(name);
        const XYZd xyz = xyz_of_radiance(illuminant_of(space));
        EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), space.white.x, 1e-12) << name;
        EXPECT_NEAR(xyz.y / (xyz.x + xyz.y + xyz.z), space.white.y, 1e-12) << name;
    }
}

TEST(Daylight, OfTheWhiteOfD65IsD65) {
    const PiecewiseLinearSpectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    const PiecewiseLinearSpectrum mixture = daylight({0.31272, 0.32903});
    for (double lambda_nm = 360.0; lambda_nm <= 830.0; lambda_nm += 5.0) {
        EXPECT_NEAR(eval(mixture, lambda_nm), eval(d65, lambda_nm), 0.3) << lambda_nm;
    }
    EXPECT_THAT([] { (void)daylight({0.6, 0.35}); }, ThrowsMessage<std::invalid_argument>(HasSubstr("(0.6, 0.35)")));
}

}  // namespace
}  // namespace emulsion
