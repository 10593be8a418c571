#include "spectrum/color_temperature.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// The CIE's way to a chromaticity: sums at the rows of the table, 5 nm apart, not integrals of lines between them.
Chromaticity chromaticity_by_sums(const PiecewiseLinearSpectrum& spectrum) {
    XYZd sum;
    for (std::size_t i = 0; i < spectrum.value.size(); ++i) {
        sum = sum + spectrum.value[i] * eval(cie_1931_2deg(), spectrum.lambda_nm[i]);
    }
    return chromaticity_of(sum);
}

double temperature_of(const Chromaticity& chromaticity) {
    const auto result = correlated_color_temperature(chromaticity);
    return result ? result->temperature_K : 0.0;
}

TEST(PlanckianLocus, IsTheIntegralOfPlancksLaw) {
    for (double t = 500.0; t <= 1e6; t *= 1.7) {
        const Uv1960 expected = uv_1960_of(xyz_of_radiance(BlackbodySpectrum{t}));
        const Uv1960 uv = cie_1931_planckian_locus().uv(t);
        EXPECT_NEAR(uv.u, expected.u, 1e-13) << t;
        EXPECT_NEAR(uv.v, expected.v, 1e-13) << t;
    }
}

TEST(CorrelatedColorTemperature, OfABlackbodyIsItsTemperature) {
    for (const double t : {500.0, 1000.0, 1234.5, 2042.0, 2855.5, 5000.0, 6500.0, 10000.0, 25000.0, 100000.0, 1e6}) {
        const auto result = correlated_color_temperature(chromaticity_of(xyz_of_radiance(BlackbodySpectrum{t})));
        ASSERT_TRUE(result) << t;
        EXPECT_NEAR(result->temperature_K, t, 1e-9 * t);
        EXPECT_NEAR(result->duv, 0.0, 1e-12) << t;
    }
}

TEST(CorrelatedColorTemperature, InvertsTemperatureAndDuv) {
    const PlanckianLocus& locus = cie_1931_planckian_locus();
    for (double t = 505.0; t < 0.99e6; t *= 1.31) {
        for (const double duv : {-kLargestDuv, -0.03, -1e-6, 0.0, 0.01, kLargestDuv}) {
            const Uv1960 uv = locus.uv(CorrelatedColorTemperature{t, duv});
            EXPECT_NEAR(std::hypot(uv.u - locus.uv(t).u, uv.v - locus.uv(t).v), std::abs(duv), 1e-15);
            const auto result = locus.nearest(uv);
            ASSERT_TRUE(result) << t << " " << duv;
            EXPECT_NEAR(result->temperature_K, t, 1e-8 * t) << duv;
            EXPECT_NEAR(result->duv, duv, 1e-14) << t;
        }
    }
}

TEST(CorrelatedColorTemperature, IsPositiveAboveTheLocus) {
    const Uv1960 on = cie_1931_planckian_locus().uv(4000.0);
    EXPECT_GT(cie_1931_planckian_locus().nearest({on.u, on.v + 0.01})->duv, 0.0) << "greenish";
    EXPECT_LT(cie_1931_planckian_locus().nearest({on.u, on.v - 0.01})->duv, 0.0) << "pinkish";
}

TEST(CorrelatedColorTemperature, IsTheNearestPoint) {
    // Against a plain search over the locus, 0.01% apart in temperature.
    const PlanckianLocus& locus = cie_1931_planckian_locus();
    for (const Uv1960& uv : {Uv1960{0.22, 0.35}, Uv1960{0.21, 0.29}, Uv1960{0.30, 0.33}}) {
        double best_K = 0.0, nearest = std::numeric_limits<double>::infinity();
        for (double t = 1000.0; t < 30000.0; t *= 1.01) {
            const double distance = std::hypot(locus.uv(t).u - uv.u, locus.uv(t).v - uv.v);
            if (distance < nearest) nearest = distance, best_K = t;
        }
        const auto result = locus.nearest(uv);
        ASSERT_TRUE(result);
        EXPECT_NEAR(result->temperature_K, best_K, 0.01 * best_K);
        EXPECT_LE(std::abs(result->duv), nearest);
    }
}

TEST(CorrelatedColorTemperature, OfDaylightIsThePublishedOne) {
    // D65: 6500 K on the temperature scale of 1964, 6503.6 K on today's; commonly rounded up to 6504 K (CIE 15:2004).
    const auto d65 =
        correlated_color_temperature(chromaticity_by_sums(tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65")));
    ASSERT_TRUE(d65);
    EXPECT_NEAR(d65->temperature_K, 6503.6, 0.1);
    EXPECT_NEAR(d65->duv, 0.0032, 5e-5) << "ANSI C78.377-2008, annex: daylight lies 0.003 above";
    EXPECT_NEAR(temperature_of({0.3127, 0.3290}), 6504.0, 0.5) << "the rounded white of BT.709";
    // Lines between the rows instead of sums: 1.0 K less.
    EXPECT_NEAR(
        temperature_of(chromaticity_of(xyz_of_radiance(tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65")))),
        6502.5, 0.1);
    // Illuminant A is a blackbody of 2848 K with c2 = 1.435e-2 m K: 2855.5 K with today's (CIE 15:2004, section 3.1).
    EXPECT_NEAR(temperature_of(chromaticity_by_sums(tabulated_spectrum("illuminants_a_d_300_830_5nm", "A"))), 2855.5,
                0.1);
}

TEST(CorrelatedColorTemperature, OfFluorescentLampsIsThePublishedOne) {
    // CIE 15:2004, table T.7, to 10 K; FL7 to 50 K: its published x, y (0.3129, 0.3292) are those of 6496 K.
    constexpr std::array<double, 12> kPublished_K = {6430, 4230, 3450, 2940, 6350, 4150,
                                                     6500, 5000, 4150, 5000, 4000, 3000};
    for (std::size_t i = 0; i < kPublished_K.size(); ++i) {
        const std::string name = "FL" + std::to_string(i + 1);
        const double by_sums_K = temperature_of(chromaticity_by_sums(tabulated_spectrum("illuminants_5nm", name)));
        // Half the rounding, and 0.1 K for the CIE's rounded second radiation constant.
        EXPECT_NEAR(by_sums_K, kPublished_K[i], name == "FL7" ? 25.1 : 5.6) << name;
        // Lines between the rows change it by less than 0.1%.
        const Chromaticity exact = chromaticity_of(xyz_of_radiance(tabulated_spectrum("illuminants_5nm", name)));
        EXPECT_NEAR(temperature_of(exact), by_sums_K, 0.0011 * by_sums_K) << name;
    }
}

TEST(CorrelatedColorTemperature, OfTheNewerFluorescentLampsIsThePublishedOne) {
    // CIE 15:2004, table T.8, to 1 K. The CIE doesn't say by which of the approximations of its time: they differ among
    // themselves by about 1 K at 6000 K.
    constexpr std::array<double, 15> kPublished_K = {2932, 3965, 6280, 2904, 4086, 4894, 2979, 4006,
                                                     4853, 5000, 5854, 2984, 3896, 5045, 6509};
    for (std::size_t i = 0; i < kPublished_K.size(); ++i) {
        const std::string name = "FL3_" + std::to_string(i + 1);
        const Chromaticity chromaticity = chromaticity_by_sums(tabulated_spectrum("illuminants_5nm", name));
        EXPECT_NEAR(temperature_of(chromaticity), kPublished_K[i], 1.5) << name;
    }
}

TEST(CorrelatedColorTemperature, GoesOnBeyondWhereItMeansMuch) {
    // sRGB green: so far from the locus that the caller must not use it, which duv says.
    const auto green = correlated_color_temperature({0.30, 0.60});
    ASSERT_TRUE(green);
    EXPECT_GT(green->duv, kLargestDuv);
}

TEST(CorrelatedColorTemperature, IsUnsetBeyondTheEndsOfTheLocus) {
    EXPECT_FALSE(correlated_color_temperature({0.15, 0.06})) << "bluer than the hottest blackbody";
    EXPECT_FALSE(correlated_color_temperature({0.735, 0.265})) << "redder than the coldest";
    EXPECT_FALSE(correlated_color_temperature(chromaticity_of(XYZd{}))) << "black";
    EXPECT_FALSE(correlated_color_temperature({std::numeric_limits<double>::infinity(), 0.3}));
}

TEST(PlanckianLocus, RefusesTemperaturesBeyondIt) {
    const PlanckianLocus& locus = cie_1931_planckian_locus();
    EXPECT_THAT([&] { (void)locus.uv(499.0); }, ThrowsMessage<std::invalid_argument>(HasSubstr("temperature_K = 499")));
    EXPECT_THROW((void)locus.uv(1.1e6), std::invalid_argument);
    EXPECT_THROW((void)locus.uv(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
    EXPECT_THROW((void)locus.uv(CorrelatedColorTemperature{0.0, 0.0}), std::invalid_argument);
    EXPECT_THAT(
        [&] {
            (void)locus.uv({5000.0, std::numeric_limits<double>::infinity()});
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr("duv = inf")));
}

}  // namespace
}  // namespace emulsion
