#include "spectrum/rgb_uplift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.h"
#include "spectrum/cie76_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/daylight.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// CIE 1976 difference of two linear RGB colours of a space.
double difference(const RgbSpace& space, const RGBd& a, const RGBd& b) {
    const Matrix3 matrix = xyz_from_rgb(space);
    const auto lab = [&](const RGBd& rgb) {
        const auto xyz = matrix * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, xyz_of(space.white));
    };
    return difference(Cie76Difference{}, lab(a), lab(b));
}

bool within_zero_and_one(const Spectrum& reflectance) {
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        const double value = eval(reflectance, lambda_nm);
        if (!(value >= 0.0 && value <= 1.0)) return false;
    }
    return true;
}

// A grid of 17^3 colours, corners included.
template <class Visit>
void for_each_grid_colour(const Visit& visit) {
    constexpr int kSteps = 16;
    const auto level = [](int i) { return static_cast<double>(i) / kSteps; };
    for (int r = 0; r <= kSteps; ++r) {
        for (int g = 0; g <= kSteps; ++g) {
            for (int b = 0; b <= kSteps; ++b) visit(RGBd{level(r), level(g), level(b)});
        }
    }
}

TEST(Reflectance, ReachesEveryColourOfSrgb) {
    const RgbSpace& space = rgb_space("sRGB");
    const RgbUplift uplift(space);
    double largest = 0.0, sum = 0.0;
    int count = 0;
    for_each_grid_colour([&](const RGBd& rgb) {
        const SigmoidSpectrum sigmoid = uplift.reflectance(rgb);
        const double error = difference(space, uplift.rgb_of(sigmoid), rgb);
        EXPECT_TRUE(within_zero_and_one(sigmoid)) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        EXPECT_LE(error, 1e-6) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        largest = std::max(largest, error);
        sum += error;
        ++count;
    });
    RecordProperty("largest_delta_e", std::to_string(largest));
    RecordProperty("mean_delta_e", std::to_string(sum / count));
    EXPECT_EQ(count, 4913);
}

TEST(Reflectance, ReachesTheEdgesAndDarkColoursOfSrgb) {
    const RgbSpace& space = rgb_space("sRGB");
    const RgbUplift uplift(space);
    for (const double scale : {1e-9, 1e-6, 1e-4, 1e-3, 0.02, 0.5, 0.98, 0.999, 1.0}) {
        for (const RGBd& hue : {RGBd{1, 0, 0}, RGBd{0, 1, 0}, RGBd{0, 0, 1}, RGBd{1, 1, 0}, RGBd{1, 0, 1},
                                RGBd{0, 1, 1}, RGBd{1, 1, 0.999}, RGBd{0.999, 1, 1}, RGBd{1, 0.5, 0.001}}) {
            const RGBd rgb = scale * hue;
            // The darkest and most saturated ones converge slowly, and may end a little early.
            const double tolerance = scale < 0.02 ? 1e-3 : 1e-6;
            EXPECT_LE(difference(space, uplift.rgb_of(uplift.reflectance(rgb)), rgb), tolerance)
                << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        }
    }
}

TEST(Reflectance, OfWiderSpacesIsPossibleAndOfLittleDifference) {
    // No reflectance at all is as saturated as the corners of these spaces. What is within reach must be reached: all
    // colours with some white in them.
    for (const char* name : {"Display_P3", "Rec2020", "ACEScg_AP1", "ROMM_ProPhoto", "ACES2065_1_AP0"}) {
        const RgbSpace& space = rgb_space(name);
        const RgbUplift uplift(space);
        for_each_grid_colour([&](const RGBd& rgb) {
            if (std::fmod(16.0 * (rgb.r + rgb.g + rgb.b), 3.0) != 0.0) return;  // every third colour
            const SigmoidSpectrum sigmoid = uplift.reflectance(rgb);
            EXPECT_TRUE(within_zero_and_one(sigmoid)) << name << ' ' << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
            const double error = difference(space, uplift.rgb_of(sigmoid), rgb);
            const auto [low, high] = std::minmax({rgb.r, rgb.g, rgb.b});
            const bool muted = high - low <= 0.25 && low >= 0.25 && high <= 0.75;
            EXPECT_TRUE(!muted || error <= 1e-6) << name << ' ' << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        });
    }
}

TEST(Reflectance, AgreesWithTheExactIntegral) {
    const RgbSpace& space = rgb_space("sRGB");
    const RgbUplift uplift(space);
    const PiecewiseLinearSpectrum d65 = illuminant_of(space);
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, d65);
    for (const RGBd& rgb : {RGBd{0.8, 0.1, 0.05}, RGBd{0.1, 0.6, 0.2}, RGBd{0.02, 0.1, 0.9}, RGBd{0.3, 0.4, 0.5}}) {
        const auto wanted = xyz_from_rgb(space) * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        const XYZd integral = xyz_of_reflectance(uplift.reflectance(rgb), d65);
        EXPECT_LE(difference(Cie76Difference{}, lab_from_xyz(integral, white),
                             lab_from_xyz({wanted[0], wanted[1], wanted[2]}, xyz_of(space.white))),
                  1e-2)
            << "the fit takes straight lines between whole nanometres, as the renderer does";
    }
}

TEST(Reflectance, GreysAreConstantAndWhiteIsExact) {
    const RgbUplift uplift(rgb_space("sRGB"));
    for (const double v : {0.0, 1e-300, 1e-6, 0.18, 0.5, 0.75, 1.0}) {
        const SigmoidSpectrum sigmoid = uplift.reflectance({v, v, v});
        for (const double lambda_nm : {360.0, 555.5, 830.0}) EXPECT_NEAR(eval(sigmoid, lambda_nm), v, 1e-15) << v;
    }
    EXPECT_EQ(eval(uplift.reflectance({0, 0, 0}), 500.0), 0.0);
    EXPECT_EQ(eval(uplift.reflectance({1, 1, 1}), 500.0), 1.0);
    const RGBd white = uplift.rgb_of(ConstantSpectrum{1.0});
    EXPECT_NEAR(white.r, 1.0, 1e-13);
    EXPECT_NEAR(white.g, 1.0, 1e-13);
    EXPECT_NEAR(white.b, 1.0, 1e-13);
}

TEST(Reflectance, RefusesWhatIsOutOfRange) {
    const RgbUplift uplift(rgb_space("sRGB"));
    EXPECT_THAT(
        [&] {
            (void)uplift.reflectance({0.5, 1.5, 0.5});
        },
        ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("g = 1.5"), HasSubstr("[0, 1]"))));
    EXPECT_THAT(
        [&] {
            (void)uplift.reflectance({-0.1, 0.5, 0.5});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("r = -0.1")));
    EXPECT_THAT(
        [&] {
            (void)uplift.reflectance({0.1, 0.5, kNaN});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("b = nan")));
    EXPECT_THAT(
        [&] {
            (void)uplift.light({0.1, -2.0, 0.0});
        },
        ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("g = -2"), HasSubstr(">= 0"))));
    EXPECT_THROW((void)uplift.light({std::numeric_limits<double>::infinity(), 0.0, 0.0}), std::invalid_argument);
}

TEST(Light, NormalisedHasTheXyzOfItsRgb) {
    const RgbSpace& space = rgb_space("sRGB");
    for (const RGBd& rgb : {RGBd{1, 1, 1}, RGBd{12, 3, 0.5}, RGBd{0.2, 0.9, 0.1}, RGBd{0, 0, 4}, RGBd{1, 0, 0}}) {
        const RgbIlluminantSpectrum light = rgb_illuminant(rgb, space);
        EXPECT_DOUBLE_EQ(light.scale, 2.0 * std::max({rgb.r, rgb.g, rgb.b}));
        const XYZd xyz = (1.0 / (kLuminousEfficacy * light_normalisation(light))) * xyz_of_radiance(light);
        const auto wanted = xyz_from_rgb(space) * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        EXPECT_NEAR(xyz.x / wanted[0], 1.0, 0.005) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        EXPECT_NEAR(xyz.y / wanted[1], 1.0, 0.005) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        EXPECT_NEAR(xyz.z / wanted[2], 1.0, 0.005) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
    }
}

TEST(Light, OfNothingIsDark) {
    const RgbIlluminantSpectrum dark = rgb_illuminant({0, 0, 0}, rgb_space("sRGB"));
    EXPECT_EQ(dark.scale, 0.0);
    EXPECT_EQ(eval(dark, 500.0), 0.0);
    EXPECT_NO_THROW(validate(dark));
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
