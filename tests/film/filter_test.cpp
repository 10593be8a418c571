#include "film/filter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "filter_examples.h"

namespace emulsion {
namespace {

using emulsion::testing::example_filters;
using emulsion::testing::name_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const FilterAxis kAxes[] = {FilterAxis::x, FilterAxis::y};

TEST(Filter, IsZeroAtAndPastTheRadiusAndEven) {
    for (const Filter& filter : example_filters()) {
        for (const FilterAxis axis : kAxes) {
            const double radius = radius_px(filter, axis);
            EXPECT_EQ(eval(filter, axis, radius), 0.0);
            EXPECT_EQ(eval(filter, axis, -radius), 0.0);
            EXPECT_EQ(eval(filter, axis, 1.5 * radius), 0.0);
            EXPECT_EQ(eval(filter, axis, std::numeric_limits<double>::infinity()), 0.0);
            EXPECT_NE(eval(filter, axis, 0.999 * radius), 0.0) << name_of(filter);
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

// It goes by the shape, not by the name.
TEST(Filter, NegativeLobesAreFound) {
    for (const Filter& filter :
         {Filter(BoxFilter{}), Filter(TriangleFilter{}), Filter(GaussianFilter{}), Filter(BlackmanHarrisFilter{}),
          Filter(BlackmanHarrisFilter{400.0f, 1e-3f}), Filter(MitchellFilter{2.0f, 2.0f, 1.0f, 0.0f}),  // the B-spline
          Filter(MitchellFilter{3.3f, 0.7f, 1.0f, 0.0f}), Filter(MitchellFilter{2.0f, 2.0f, 0.4f, 0.0f}),
          Filter(LanczosSincFilter{1.0f, 0.7f})}) {
        EXPECT_FALSE(has_negative_lobes(filter)) << name_of(filter);
    }
    for (const Filter& filter :
         {Filter(MitchellFilter{}), Filter(MitchellFilter{2.0f, 2.0f, 1.0f, 0.1f}), Filter(CatmullRomFilter{}),
          Filter(CatmullRomFilter{0.1f, 900.0f}), Filter(LanczosSincFilter{}), Filter(LanczosSincFilter{0.9f, 1.2f}),
          Filter(LanczosSincFilter{1.2f, 0.9f}), Filter(LanczosSincFilter{400.0f, 0.5f, 300.0f})}) {
        EXPECT_TRUE(has_negative_lobes(filter)) << name_of(filter);
    }
    for (const Filter& filter : example_filters()) {
        bool is_negative = false;
        for (const FilterAxis axis : kAxes) {
            const double radius = radius_px(filter, axis);
            for (int i = 0; i < 5000; ++i) is_negative = is_negative || eval(filter, axis, i * radius / 5000.0) < -1e-9;
        }
        EXPECT_EQ(has_negative_lobes(filter), is_negative) << name_of(filter);
    }
}

TEST(Filter, ValidateNamesTheParameterItsValueAndItsRange) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const auto expect_refused = [](const Filter& filter, const std::string& kind, const std::string& field) {
        EXPECT_THAT([&] { validate(filter); }, ThrowsMessage<std::invalid_argument>(AllOf(
                                                   HasSubstr(kind), HasSubstr(field), HasSubstr("must be in ("))));
    };
    expect_refused(BoxFilter{0.0f, 1.0f}, "box", "x-radius = 0:");
    expect_refused(TriangleFilter{1.0f, -1.0f}, "triangle", "y-radius = -1:");
    expect_refused(GaussianFilter{nan, 1.0f}, "gaussian", "x-radius = nan:");
    expect_refused(GaussianFilter{1.0f, 1.0f, 0.0f}, "gaussian", "sigma = 0:");
    expect_refused(MitchellFilter{2.0f, 2.0f, nan, 0.0f}, "mitchell", "b = nan:");
    expect_refused(MitchellFilter{2.0f, 2.0f, 0.0f, HUGE_VALF}, "mitchell", "c = inf:");
    expect_refused(LanczosSincFilter{4.0f, 4.0f, -3.0f}, "sinc", "tau = -3:");
    for (const Filter& filter : example_filters()) EXPECT_NO_THROW(validate(filter));
}

TEST(Filter, ValidateRefusesWhatCannotBeNormalised) {
    const auto expect_refused = [](const Filter& filter) {
        EXPECT_THAT([&] { validate(filter); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(name_of(filter)), HasSubstr("1/1024"))));
    };
    expect_refused(GaussianFilter{1e3f, 1e3f, 1e-30f});      // every value rounds to nothing
    expect_refused(GaussianFilter{1.0f, 1.0f, 1e30f});       // flat, and lowered to nothing
    expect_refused(MitchellFilter{2.0f, 2.0f, 1e9f, 0.0f});  // its lobes leave a milliardth over
    expect_refused(MitchellFilter{2.0f, 2.0f, 0.0f, 5000.0f});
    EXPECT_NO_THROW(validate(MitchellFilter{2.0f, 2.0f, 0.0f, 3.0f}));
}

TEST(Filter, TakesAnyRadius) {
    for_each_alternative<Filter>([](auto filter) {
        for (const float radius_px : {1e-3f, 0.5f, 17.3f, 400.0f}) {
            filter.x_radius_px = radius_px;
            EXPECT_NO_THROW(validate(filter)) << name_of(filter);
            EXPECT_EQ(eval(filter, FilterAxis::x, static_cast<double>(radius_px)), 0.0) << name_of(filter);
            EXPECT_GT(eval(filter, FilterAxis::x, 0.0), 0.0) << name_of(filter);
        }
    });
}

TEST(Filter, TextFormReadsBackAsTheSameFilter) {
    for (const Filter& filter : example_filters()) EXPECT_EQ(parse_named<Filter>(to_text(filter), "filter"), filter);
    EXPECT_EQ(to_text(Filter(GaussianFilter{2.0f, 1.0f, 0.7f})), "gaussian:x-radius=2,y-radius=1,sigma=0.7");
    EXPECT_THROW(static_cast<void>(parse_named<Filter>("box:x-radius=0", "filter")), std::invalid_argument);
}

double as_double(float value) { return static_cast<double>(value); }

/// Si(x), the integral of sin(t)/t from 0 to x, by its power series; to 1e-9 for x <= 20.
double sine_integral(double x) {
    double term = x, sum = x;
    for (int k = 1; k < 80; ++k) {
        term *= -x * x / (2.0 * k * (2.0 * k + 1.0));
        sum += term / (2.0 * k + 1.0);
    }
    return sum;
}

// Integrals over [-radius, radius] in closed form.
double closed_integral(const BoxFilter&, double radius) { return 2.0 * radius; }
double closed_integral(const TriangleFilter&, double radius) { return radius; }
// The normal distribution's mass within the radius, less the rectangle that it is lowered by.
double closed_integral(const GaussianFilter& filter, double radius) {
    const double sigma = as_double(filter.sigma_px), at_end = radius / sigma;
    const double density = std::exp(-0.5 * at_end * at_end) / (sigma * std::sqrt(2.0 * std::numbers::pi));
    return std::erf(at_end / std::numbers::sqrt2) - 2.0 * radius * density;
}
// Mitchell & Netravali's constraint: k is normalised, whatever b and c, at a radius of 2.
double closed_integral(const MitchellFilter&, double radius) { return 0.5 * radius; }
double closed_integral(const CatmullRomFilter&, double radius) { return 0.5 * radius; }
// By parts: the integral of sin(ax) sin(bx)/x^2 over [0, r] is
// (a + b)/2 Si((a + b) r) - (a - b)/2 Si((a - b) r) - sin(ar) sin(br)/r.
double closed_integral(const LanczosSincFilter& filter, double radius) {
    const double a = std::numbers::pi, b = a / as_double(filter.tau), r = radius;
    const double half = 0.5 * (a + b) * sine_integral((a + b) * r) - 0.5 * (a - b) * sine_integral((a - b) * r) -
                        std::sin(a * r) * std::sin(b * r) / r;
    return 2.0 * half / (a * b);
}
// Its constant term: the cosines have whole periods.
double closed_integral(const BlackmanHarrisFilter&, double radius) { return 2.0 * 0.35875 * radius; }

// Midpoints, whose error is of second order at the bends: (radius / 1e5)^2 / 24 times the change of slope.
TEST(Filter, HasTheIntegralOfItsClosedForm) {
    for (const Filter& filter : example_filters()) {
        for (const FilterAxis axis : kAxes) {
            constexpr int kSteps = 200000;
            const double radius = radius_px(filter, axis), step = 2.0 * radius / kSteps;
            double sum = 0.0;
            for (int i = 0; i < kSteps; ++i) sum += step * eval(filter, axis, -radius + (i + 0.5) * step);
            const double expected =
                std::visit([radius](const auto& shape) { return closed_integral(shape, radius); }, filter);
            EXPECT_NEAR(sum, expected, 2e-9 * (1.0 + expected)) << name_of(filter);
        }
    }
}

bool has_negative_lobes(const BoxFilter&) { return false; }
bool has_negative_lobes(const TriangleFilter&) { return false; }
bool has_negative_lobes(const GaussianFilter&) { return false; }
// With d = 2 - |x|, the outer cubic is (b/6 + c) d^3 - c d^2: negative at small d if c > 0.
bool has_negative_lobes(const MitchellFilter& filter) { return filter.c > 0.0f; }
bool has_negative_lobes(const CatmullRomFilter&) { return true; }
bool has_negative_lobes(const LanczosSincFilter& filter) { return filter.x_radius_px > 1.0f; }
bool has_negative_lobes(const BlackmanHarrisFilter&) { return false; }

TEST(Filter, IsNegativeInItsLobesOnly) {
    for (const Filter& filter : example_filters()) {
        const double radius = radius_px(filter, FilterAxis::x);
        double least = 0.0, greatest = 0.0;
        for (int i = 0; i < 10000; ++i) {
            const double f = eval(filter, FilterAxis::x, radius * i / 10000.0);
            least = std::min(least, f);
            greatest = std::max(greatest, f);
        }
        EXPECT_EQ(greatest, eval(filter, FilterAxis::x, 0.0)) << name_of(filter);
        if (std::visit([](const auto& shape) { return has_negative_lobes(shape); }, filter)) {
            EXPECT_LT(least, -0.01 * greatest) << name_of(filter);
        } else {
            EXPECT_EQ(least, 0.0) << name_of(filter);
        }
    }
}

TEST(Filter, CatmullRomIsMitchellsOfNoBlurAndHalfTheRinging) {
    for (int i = -40; i <= 40; ++i) {
        EXPECT_EQ(eval(CatmullRomFilter{}, FilterAxis::x, 0.05 * i),
                  eval(MitchellFilter{2.0f, 2.0f, 0.0f, 0.5f}, FilterAxis::x, 0.05 * i));
    }
    for (int i = 1; i < 3; ++i) EXPECT_EQ(eval(CatmullRomFilter{}, FilterAxis::x, i), 0.0) << "it interpolates";
}

// Harris' table: the four terms add up to 1 in the middle; a0 - a2 at half the radius; 6e-5 at the end.
TEST(Filter, BlackmanHarrisHasTheValuesOfTheWindow) {
    const Filter filter = BlackmanHarrisFilter{};
    EXPECT_NEAR(eval(filter, FilterAxis::x, 0.0), 1.0, 1e-15);
    EXPECT_NEAR(eval(filter, FilterAxis::x, 1.0), 0.35875 - 0.14128, 1e-15);
    EXPECT_NEAR(eval(filter, FilterAxis::x, 2.0 * (1.0 - 1e-9)), 6e-5, 1e-12);
}

}  // namespace
}  // namespace emulsion
