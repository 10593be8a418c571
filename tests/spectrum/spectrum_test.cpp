#include "spectrum/spectrum.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(PiecewiseLinear, IsStraightBetweenKnotsAndZeroOutside) {
    const PiecewiseLinearSpectrum spectrum{{400.0, 450.0, 700.5}, {2.0, 1.0, 3.0}};
    EXPECT_EQ(eval(spectrum, 399.999), 0.0);
    EXPECT_EQ(eval(spectrum, 400.0), 2.0);
    EXPECT_EQ(eval(spectrum, 425.0), 1.5);
    EXPECT_EQ(eval(spectrum, 450.0), 1.0);
    EXPECT_NEAR(eval(spectrum, 575.25), 2.0, 1e-15);
    EXPECT_EQ(eval(spectrum, 700.5), 3.0);
    EXPECT_EQ(eval(spectrum, 700.501), 0.0);
    EXPECT_THAT(knots_nm(spectrum), ElementsAre(400.0, 450.0, 700.5));
}

TEST(PiecewiseLinear, LimitsDifferOnlyAtTheEnds) {
    const PiecewiseLinearSpectrum spectrum{{400.0, 450.0, 700.0}, {2.0, 1.0, 3.0}};
    EXPECT_EQ(limit(spectrum, 400.0, Side::below), 0.0);
    EXPECT_EQ(limit(spectrum, 400.0, Side::above), 2.0);
    EXPECT_EQ(limit(spectrum, 450.0, Side::below), 1.0);
    EXPECT_EQ(limit(spectrum, 450.0, Side::above), 1.0);
    EXPECT_EQ(limit(spectrum, 700.0, Side::below), 3.0);
    EXPECT_EQ(limit(spectrum, 700.0, Side::above), 0.0);
}

TEST(PiecewiseLinear, OfOneKnotIsThatPointOnly) {
    const PiecewiseLinearSpectrum spectrum{{500.0}, {2.0}};
    EXPECT_EQ(eval(spectrum, 500.0), 2.0);
    EXPECT_EQ(limit(spectrum, 500.0, Side::below), 0.0);
    EXPECT_EQ(limit(spectrum, 500.0, Side::above), 0.0);
}

TEST(Sigmoid, FollowsItsFormula) {
    const SigmoidSpectrum spectrum{{4.0, -3.0, 0.5}};
    for (double lambda_nm = 360.0; lambda_nm <= 830.0; lambda_nm += 23.5) {
        const double t = (lambda_nm - 360.0) / 470.0;
        const double x = 4.0 * t * t - 3.0 * t + 0.5;
        EXPECT_NEAR(eval(spectrum, lambda_nm), 0.5 + x / (2.0 * std::hypot(1.0, x)), 1e-15);
    }
    EXPECT_EQ(eval(SigmoidSpectrum{}, 500.0), 0.5);
    EXPECT_THAT(knots_nm(spectrum), IsEmpty());
}

TEST(Sigmoid, StaysWithinZeroAndOneForAnyCoefficients) {
    for (const double c : {1e3, 1e7, 1e9, 1e160, 1e308, kInfinity}) {
        EXPECT_NEAR(eval(SigmoidSpectrum{{0.0, 0.0, c}}, 500.0), 1.0, 1e-6) << c;
        EXPECT_LE(eval(SigmoidSpectrum{{0.0, 0.0, c}}, 500.0), 1.0) << c;
        EXPECT_NEAR(eval(SigmoidSpectrum{{0.0, 0.0, -c}}, 500.0), 0.0, 1e-6) << c;
        EXPECT_GE(eval(SigmoidSpectrum{{0.0, 0.0, -c}}, 500.0), 0.0) << c;
    }
    EXPECT_EQ(eval(SigmoidSpectrum{{0.0, 0.0, kInfinity}}, 360.0), 1.0);
    EXPECT_EQ(eval(SigmoidSpectrum{{0.0, 0.0, -kInfinity}}, 830.0), 0.0);
}

TEST(RgbIlluminant, IsTheProductOfItsParts) {
    const SigmoidSpectrum sigmoid{{4.0, -3.0, 0.5}};
    const PiecewiseLinearSpectrum illuminant{{400.0, 700.0}, {1.0, 4.0}};
    const RgbIlluminantSpectrum light{sigmoid, illuminant, 2.5};
    EXPECT_DOUBLE_EQ(eval(light, 500.0), 2.5 * eval(sigmoid, 500.0) * 2.0);
    EXPECT_EQ(eval(light, 399.0), 0.0);
    EXPECT_EQ(limit(light, 400.0, Side::below), 0.0);
    EXPECT_THAT(knots_nm(light), ElementsAre(400.0, 700.0));
}

TEST(Validate, NamesFieldAndValue) {
    const PiecewiseLinearSpectrum line{{400.0, 700.0}, {1.0, 1.0}};
    const std::vector<std::pair<Spectrum, std::string>> bad = {
        {ConstantSpectrum{kNaN}, "value = nan"},
        {PiecewiseLinearSpectrum{}, "0 wavelengths"},
        {PiecewiseLinearSpectrum{{400.0}, {1.0, 2.0}}, "1 wavelengths and 2 values"},
        {PiecewiseLinearSpectrum{{400.0, kInfinity}, {1.0, 2.0}}, "lambda_nm[1] = inf"},
        {PiecewiseLinearSpectrum{{400.0, 500.0}, {1.0, kNaN}}, "value[1] = nan"},
        {PiecewiseLinearSpectrum{{400.0, 400.0}, {1.0, 2.0}}, "lambda_nm[1] = 400"},
        {BlackbodySpectrum{0.0}, "temperature_K = 0"},
        {BlackbodySpectrum{-300.0}, "temperature_K = -300"},
        {BlackbodySpectrum{kInfinity}, "temperature_K = inf"},
        {SigmoidSpectrum{{kInfinity, 0.0, 0.0}}, "c[0] = inf"},
        {SigmoidSpectrum{{0.0, kNaN, 0.0}}, "c[1] = nan"},
        {SigmoidSpectrum{{0.0, 0.0, kNaN}}, "c[2] = nan"},
        {RgbIlluminantSpectrum{SigmoidSpectrum{}, line, kNaN}, "scale = nan"},
        {RgbIlluminantSpectrum{SigmoidSpectrum{}, {}, 1.0}, "0 wavelengths"},
    };
    for (const auto& [spectrum, message] : bad) {
        EXPECT_THAT([&s = spectrum] { validate(s); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(message), HasSubstr("expected"))));
    }
}

TEST(Validate, AcceptsWhatIsInRange) {
    EXPECT_NO_THROW(validate(ConstantSpectrum{-1.0}));
    EXPECT_NO_THROW(validate(PiecewiseLinearSpectrum{{500.0}, {1.0}}));
    EXPECT_NO_THROW(validate(BlackbodySpectrum{1.0}));
    EXPECT_NO_THROW(validate(SigmoidSpectrum{{0.0, 0.0, -kInfinity}}));
}

}  // namespace
}  // namespace emulsion
