#include "film/filter.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<Filter> filters() {
    return {BoxFilter{},
            BoxFilter{1.0f, 2.0f},
            TriangleFilter{},
            TriangleFilter{1.0f, 3.0f},
            GaussianFilter{},
            MitchellFilter{},
            LanczosSincFilter{},
            MitchellFilter{3.0f, 2.0f, 0.0f, 0.5f},
            GaussianFilter{2, 1, 1}};
}

const FilterAxis kAxes[] = {FilterAxis::x, FilterAxis::y};

TEST(Filter, IsZeroAtAndPastTheRadiusAndEven) {
    for (const Filter& filter : filters()) {
        for (const FilterAxis axis : kAxes) {
            const double radius = radius_px(filter, axis);
            EXPECT_EQ(eval(filter, axis, radius), 0.0);
            EXPECT_EQ(eval(filter, axis, -radius), 0.0);
            EXPECT_EQ(eval(filter, axis, 1.5 * radius), 0.0);
            EXPECT_EQ(eval(filter, axis, std::numeric_limits<double>::infinity()), 0.0);
            EXPECT_NE(eval(filter, axis, 0.999 * radius), 0.0);
            for (int i = 0; i < 37; ++i) {
                const double x = i * radius / 37.0;
                EXPECT_EQ(eval(filter, axis, x), eval(filter, axis, -x));
            }
        }
    }
}

TEST(Filter, HasTheRadiusOfItsAxis) {
    EXPECT_EQ(radius_px(BoxFilter{1.0f, 2.0f}, FilterAxis::x), 1.0);
    EXPECT_EQ(radius_px(BoxFilter{1.0f, 2.0f}, FilterAxis::y), 2.0);
    EXPECT_EQ(radius_px(LanczosSincFilter{}, FilterAxis::y), 4.0);
}

TEST(Filter, BoxIsOneInside) { EXPECT_EQ(eval(BoxFilter{}, FilterAxis::x, 0.4999), 1.0); }

TEST(Filter, TriangleIsATent) {
    EXPECT_DOUBLE_EQ(eval(TriangleFilter{}, FilterAxis::x, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(eval(TriangleFilter{}, FilterAxis::x, -0.5), 0.75);
}

// The density of the normal distribution at 0 and 1 sigma is 0.398942 / sigma and 0.241971 / sigma, at 3 sigma
// 0.00443185 / sigma.
TEST(Filter, GaussianIsTheNormalDensityLessItsValueAtTheRadius) {
    EXPECT_NEAR(eval(GaussianFilter{}, FilterAxis::x, 0.0), (0.398942 - 0.00443185) / 0.5, 2e-6);
    EXPECT_NEAR(eval(GaussianFilter{}, FilterAxis::x, 0.5), (0.241971 - 0.00443185) / 0.5, 2e-6);
}

// Values of the paper's polynomials for B = C = 1/3: k(0) = 8/9, k(1) = 1/18, k(1.5) = -5/144.
TEST(Filter, MitchellHasThePolynomialsOfThePaper) {
    const Filter filter = MitchellFilter{};  // radius 2: k's argument is the offset
    EXPECT_NEAR(eval(filter, FilterAxis::x, 0.0), 8.0 / 9.0, 1e-7);
    EXPECT_NEAR(eval(filter, FilterAxis::x, 1.0), 1.0 / 18.0, 1e-7);
    EXPECT_NEAR(eval(filter, FilterAxis::x, 1.5), -5.0 / 144.0, 1e-7);
    EXPECT_NEAR(eval(MitchellFilter{4.0f, 4.0f}, FilterAxis::x, 2.0), 1.0 / 18.0, 1e-7) << "stretched to its radius";
    const Filter b_spline = MitchellFilter{2.0f, 2.0f, 1.0f, 0.0f};
    EXPECT_NEAR(eval(b_spline, FilterAxis::x, 0.0), 2.0 / 3.0, 1e-7);
    const Filter catmull_rom = MitchellFilter{2.0f, 2.0f, 0.0f, 0.5f};
    EXPECT_NEAR(eval(catmull_rom, FilterAxis::x, 1.0), 0.0, 1e-7);
    EXPECT_NEAR(eval(catmull_rom, FilterAxis::x, 1.5), -1.0 / 16.0, 1e-7);
}

// Pieces with B = C = 1/3 at whole pixels add up to 1 wherever they are centred, as those of every B and C do.
TEST(Filter, MitchellWeightsOfAllPixelsSumToOne) {
    for (const MitchellFilter& filter : {MitchellFilter{}, MitchellFilter{2.0f, 2.0f, 0.1f, 0.9f}}) {
        for (int k = 0; k < 8; ++k) {
            double sum = 0.0;
            for (int i = -2; i <= 2; ++i) sum += eval(filter, FilterAxis::x, 0.13 * k + i);
            EXPECT_NEAR(sum, 1.0, 1e-12);
        }
    }
}

TEST(Filter, SincHasItsZerosAtWholePixelsAndItsWindowAtTau) {
    const Filter filter = LanczosSincFilter{};
    EXPECT_EQ(eval(filter, FilterAxis::x, 0.0), 1.0);
    for (int i = 1; i < 4; ++i) EXPECT_NEAR(eval(filter, FilterAxis::x, i), 0.0, 1e-15);
    const double pi = std::numbers::pi;
    EXPECT_NEAR(eval(filter, FilterAxis::x, 1.5), -1.0 / (1.5 * pi) * (1.0 / (0.5 * pi)), 1e-12);
    // Past tau the window is negative.
    EXPECT_NEAR(eval(filter, FilterAxis::x, 3.5), -1.0 / (3.5 * pi) * std::sin(3.5 / 3.0 * pi) / (3.5 / 3.0 * pi),
                1e-12);
    EXPECT_NEAR(eval(filter, FilterAxis::x, 1e-9), 1.0, 1e-15);
}

TEST(Filter, ValidateNamesTheParameterItsValueAndItsRange) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto expect_refused = [](const Filter& filter, const std::string& kind, const std::string& field) {
        EXPECT_THAT([&] { validate(filter); }, ThrowsMessage<std::invalid_argument>(
                                                   AllOf(HasSubstr(kind), HasSubstr(field), HasSubstr("expected"))));
    };
    expect_refused(BoxFilter{0.0f, 1.0f}, "box", "x_radius_px is 0");
    expect_refused(TriangleFilter{1.0f, -1.0f}, "triangle", "y_radius_px is -1");
    expect_refused(GaussianFilter{nan, 1.0f}, "gaussian", "x_radius_px is nan");
    expect_refused(GaussianFilter{1.0f, 1.0f, 0.0f}, "gaussian", "sigma_px is 0");
    expect_refused(MitchellFilter{2.0f, 2.0f, nan, 0.0f}, "mitchell", "b is nan");
    expect_refused(MitchellFilter{2.0f, 2.0f, 0.0f, HUGE_VALF}, "mitchell", "c is inf");
    expect_refused(LanczosSincFilter{4.0f, 4.0f, -3.0f}, "sinc", "tau is -3");
    for (const Filter& filter : filters()) EXPECT_NO_THROW(validate(filter));
}

}  // namespace
}  // namespace emulsion
