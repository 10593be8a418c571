// What every method must keep, over all alternatives of UpliftMethod.

#include "spectrum/rgb_uplift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.h"
#include "spectrum/cie76_difference.h"
#include "spectrum/cielab.h"
#include "spectrum/colorimetry.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// CIE 1976 difference of two linear RGB colours of a space.
double difference_of(const RgbSpace& space, const RGBd& a, const RGBd& b) {
    const Matrix3 matrix = xyz_from_rgb(space);
    const auto lab = [&](const RGBd& rgb) {
        const auto xyz = matrix * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        return lab_from_xyz({xyz[0], xyz[1], xyz[2]}, xyz_of(space.white));
    };
    return difference(Cie76Difference{}, lab(a), lab(b));
}

template <class Visit>
void for_each_grid_colour(int steps, const Visit& visit) {
    const auto level = [steps](int i) { return static_cast<double>(i) / steps; };
    for (int r = 0; r <= steps; ++r) {
        for (int g = 0; g <= steps; ++g) {
            for (int b = 0; b <= steps; ++b) visit(RGBd{level(r), level(g), level(b)});
        }
    }
}

// What a method may be off by in sRGB. Exact but for rounding and the solver's 1e-9; the table's figure is measured.
template <class Method>
constexpr double kRoundTrip = 1e-8;
template <>
constexpr double kRoundTrip<SigmoidTableUplift> = 0.4;

// test(method, uplift to sRGB) for every method.
template <class Test>
void for_each_uplift(const Test& test) {
    for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
        SCOPED_TRACE(Method::kName);
        test(method, RgbUplift(rgb_space("sRGB"), method));
    });
}

TEST(EveryUplift, HasTheColour) {
    for_each_uplift([]<class Method>(const Method&, const RgbUplift& uplift) {
        for_each_grid_colour(4, [&](const RGBd& rgb) {
            EXPECT_LE(difference_of(rgb_space("sRGB"), uplift.rgb_of(uplift.reflectance(rgb)), rgb), kRoundTrip<Method>)
                << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        });
    });
}

TEST(EveryUplift, StaysWithinZeroAndOneInEverySpaceThatItTakes) {
    int served = 0;
    for (const char* name : {"sRGB", "Display_P3", "Rec2020", "ACEScg_AP1"}) {
        for_each_alternative<UpliftMethod>([&]<class Method>(const Method& method) {
            std::optional<RgbUplift> uplift;
            try {
                uplift.emplace(rgb_space(name), method);
            } catch (const std::invalid_argument& error) {
                EXPECT_THAT(error.what(), HasSubstr("expected")) << name << ' ' << Method::kName;
                return;
            }
            ++served;
            for_each_grid_colour(2, [&](const RGBd& rgb) {
                const Spectrum reflectance = uplift->reflectance(rgb);
                EXPECT_NO_THROW(validate(reflectance));
                double least = 1.0, largest = 0.0;
                for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
                    least = std::min(least, eval(reflectance, lambda_nm));
                    largest = std::max(largest, eval(reflectance, lambda_nm));
                }
                EXPECT_GE(least, 0.0) << name << ' ' << Method::kName << ' ' << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
                EXPECT_LE(largest, 1.0) << name << ' ' << Method::kName << ' ' << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
            });
        });
    }
    EXPECT_EQ(served, 17) << "five methods in four spaces, but no Mallett-Yuksel basis in the three wider ones";
}

TEST(EveryUplift, GreysAreConstant) {
    for_each_uplift([](const auto&, const RgbUplift& uplift) {
        for (const double v : {0.0, 1e-300, 1e-6, 0.18, 0.5, 0.75, 1.0}) {
            const Spectrum reflectance = uplift.reflectance({v, v, v});
            for (const double lambda_nm : {360.0, 414.5, 555.5, 830.0}) {
                EXPECT_NEAR(eval(reflectance, lambda_nm), v, 1e-15) << v;
            }
        }
        EXPECT_EQ(eval(uplift.reflectance({0, 0, 0}), 500.0), 0.0);
        const RGBd white = uplift.rgb_of(ConstantSpectrum{1.0});
        EXPECT_NEAR(white.r, 1.0, 1e-13);
        EXPECT_NEAR(white.g, 1.0, 1e-13);
        EXPECT_NEAR(white.b, 1.0, 1e-13);
    });
}

TEST(EveryUplift, UnboundedScalesWithTheColour) {
    for_each_uplift([](const auto&, const RgbUplift& uplift) {
        const RGBd rgb = {0.75, 0.25, 0.0625};
        const Spectrum one = uplift.unbounded(rgb);
        for (const double lambda_nm : {410.0, 500.0, 590.0, 680.0}) {
            // The colour that is uplifted is the same to the last bit for powers of two.
            EXPECT_EQ(eval(uplift.unbounded(1024.0 * rgb), lambda_nm), 1024.0 * eval(one, lambda_nm)) << lambda_nm;
            EXPECT_NEAR(eval(uplift.unbounded(3.0 * rgb), lambda_nm), 3.0 * eval(one, lambda_nm), 1e-8) << lambda_nm;
            EXPECT_EQ(eval(uplift.unbounded({0, 0, 0}), lambda_nm), 0.0);
        }
    });
}

TEST(EveryUplift, UnboundedIsTheReflectanceOfHalfTheBrightestColourScaled) {
    // pbrt-v4, RGBUnboundedSpectrum: scale = 2 max(r, g, b), sigmoid of rgb / scale.
    for_each_uplift([](const auto&, const RgbUplift& uplift) {
        const Spectrum unbounded = uplift.unbounded({4.0, 1.0, 3.0}), bounded = uplift.reflectance({0.5, 0.125, 0.375});
        for (const double lambda_nm : {410.0, 500.0, 590.0, 680.0}) {
            EXPECT_NEAR(eval(unbounded, lambda_nm), 8.0 * eval(bounded, lambda_nm), 1e-14) << lambda_nm;
        }
    });
}

TEST(EveryUplift, LightHasTheXyzOfItsRgb) {
    // As far as the tabulated D65 has the chromaticity (0.3127, 0.3290): 3e-4. The table is less exact.
    for_each_uplift([]<class Method>(const Method&, const RgbUplift& uplift) {
        const double tolerance = kRoundTrip<Method> > 0.1 ? 0.01 : 2e-3;
        for (const RGBd& rgb : {RGBd{1, 1, 1}, RGBd{12, 3, 0.5}, RGBd{0.2, 0.9, 0.1}, RGBd{0, 0, 4}, RGBd{1, 0, 0}}) {
            const XYZd xyz =
                (1.0 / (kLuminousEfficacy * uplift.light_normalisation())) * xyz_of_radiance(uplift.light(rgb));
            const auto wanted = xyz_from_rgb(rgb_space("sRGB")) * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
            EXPECT_NEAR(xyz.x / wanted[0], 1.0, tolerance) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
            EXPECT_NEAR(xyz.y / wanted[1], 1.0, tolerance) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
            EXPECT_NEAR(xyz.z / wanted[2], 1.0, tolerance) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        }
        const Spectrum white = uplift.light({2, 2, 2});
        EXPECT_NEAR(eval(white, 560.0), 2.0 * eval(uplift.illuminant(), 560.0), 1e-12);
        EXPECT_NEAR(photometric_integral(white) / uplift.light_normalisation(), 2.0, 1e-12);
        EXPECT_EQ(eval(uplift.light({0, 0, 0}), 500.0), 0.0);
        EXPECT_NO_THROW(validate(uplift.light({0, 0, 0})));
    });
}

TEST(EveryUplift, RefusesWhatIsOutOfRange) {
    for_each_uplift([](const auto&, const RgbUplift& uplift) {
        const auto message = [](const auto& matcher) { return ThrowsMessage<std::invalid_argument>(matcher); };
        const auto reflectance = [&](const RGBd& rgb) { return [&, rgb] { (void)uplift.reflectance(rgb); }; };
        EXPECT_THAT(reflectance({0.5, 1.5, 0.5}), message(AllOf(HasSubstr("g = 1.5"), HasSubstr("[0, 1]"))));
        EXPECT_THAT(reflectance({-0.1, 0.5, 0.5}), message(HasSubstr("r = -0.1")));
        EXPECT_THAT(reflectance({0.1, 0.5, kNaN}), message(HasSubstr("b = nan")));
        EXPECT_THAT(
            [&] {
                (void)uplift.light({0.1, -2.0, 0.0});
            },
            message(AllOf(HasSubstr("g = -2"), HasSubstr(">= 0"))));
        EXPECT_THAT([&] { (void)uplift.unbounded({0.1, -2.0, 0.0}); }, message(HasSubstr("g = -2")));
        EXPECT_THROW((void)uplift.light({kInf, 0.0, 0.0}), std::invalid_argument);
        EXPECT_THROW((void)uplift.unbounded({0.0, 0.0, std::numeric_limits<double>::max()}), std::invalid_argument)
            << "twice that is infinite";
    });
}

TEST(UpliftMethod, IsFoundByName) {
    EXPECT_EQ(parse_named<UpliftMethod>("mallett-yuksel", "uplift"), UpliftMethod(BasisUplift{}));
    EXPECT_THAT([] { (void)parse_named<UpliftMethod>("smit", "uplift"); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("smits")));
}

TEST(RgbIlluminant, IsTheExactSigmoidsLight) {
    const RgbIlluminantSpectrum light = rgb_illuminant({12, 3, 0.5}, rgb_space("sRGB"));
    EXPECT_EQ(light.scale, 24.0);
    const RgbUplift uplift(rgb_space("sRGB"));
    EXPECT_EQ(Spectrum(light), uplift.light({12, 3, 0.5}));
    EXPECT_EQ(light_normalisation(light), uplift.light_normalisation());
}

}  // namespace
}  // namespace emulsion
