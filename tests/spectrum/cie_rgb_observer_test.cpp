#include "spectrum/cie_rgb_observer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace emulsion {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

// What is printed with CIE 1931 (for example Wyszecki & Stiles, Color Science, 2nd ed., 1982, section 3.3).
constexpr Matrix3 kPublished = {
    {{{2.768892, 1.751748, 1.130160}, {1.0, 4.590700, 0.060100}, {0.0, 0.056508, 5.594292}}}};

double column_sum(const Matrix3& matrix, std::size_t j) { return matrix.m[0][j] + matrix.m[1][j] + matrix.m[2][j]; }

TEST(CieRgbObserver, GivesEachPrimaryItselfAlone) {
    // An exact property of the derivation, though 546.1 and 435.8 nm lie between the rows of the table.
    for (std::size_t j = 0; j < 3; ++j) {
        const auto [r, g, b] = eval(cie_rgb_1931(), kCieRgbPrimaries_nm[j]);
        const std::array<double, 3> amount = {r, g, b};
        for (std::size_t i = 0; i < 3; ++i) {
            if (i == j) continue;
            EXPECT_NEAR(amount[i], 0.0, 1e-15) << i << " at " << kCieRgbPrimaries_nm[j] << " nm";
        }
        EXPECT_GT(amount[j], 0.004);
    }
}

TEST(CieRgbObserver, HasEqualAreas) {
    RGBd sum;
    for (const RGBd& value : cie_rgb_1931().value) sum = sum + value;
    EXPECT_NEAR(sum.g / sum.r, 1.0, 1e-13);
    EXPECT_NEAR(sum.b / sum.r, 1.0, 1e-13);
}

TEST(CieRgbObserver, ReproducesXyz) {
    const Matrix3& xyz_from_rgb = cie_rgb_1931().xyz_from_rgb;
    for (const double lambda_nm : {360.0, 435.8, 500.5, 546.1, 599.25, 830.0}) {
        const RGBd rgb = eval(cie_rgb_1931(), lambda_nm);
        const auto xyz = xyz_from_rgb * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
        const XYZd expected = eval(cie_1931_2deg(), lambda_nm);
        EXPECT_NEAR(xyz[0], expected.x, 1e-14);
        EXPECT_NEAR(xyz[1], expected.y, 1e-14);
        EXPECT_NEAR(xyz[2], expected.z, 1e-14);
    }
    EXPECT_EQ(eval(cie_rgb_1931(), 359.5), RGBd{});
}

// The chromaticities of the spectrum were written down to four decimals in 1931, and the primaries are interpolated
// between wavelengths 5 nm apart: one unit of the fourth decimal.
TEST(CieRgbObserver, HasThePrimariesOfThePublishedMatrix) {
    const Matrix3& derived = cie_rgb_1931().xyz_from_rgb;
    for (std::size_t j = 0; j < 3; ++j) {
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(derived.m[i][j] / column_sum(derived, j), kPublished.m[i][j] / column_sum(kPublished, j), 1e-4)
                << i << ", " << j;
        }
    }
}

// 1 : 4.5907 : 0.0601. With half a unit of the fourth decimal on each chromaticity of the published primaries, all to
// the worst side, green moves by 9.0e-4 of itself and blue, with its y of 0.00886, by 6.5e-3.
TEST(CieRgbObserver, HasThePublishedLuminanceRatios) {
    const auto& luminance = cie_rgb_1931().xyz_from_rgb.m[1];
    EXPECT_NEAR(luminance[0], 1.0, 1e-15);
    EXPECT_NEAR(luminance[1] / 4.5907, 1.0, 9.0e-4);
    EXPECT_NEAR(luminance[2] / 0.0601, 1.0, 6.5e-3);
}

// The other elements follow from those chromaticities and luminances: 9.0e-4 of 4.59, halved.
TEST(CieRgbObserver, HasThePublishedMatrix) {
    const Matrix3& derived = cie_rgb_1931().xyz_from_rgb;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(derived.m[i][j], kPublished.m[i][j], 2e-3) << i << ", " << j;
        }
    }
    EXPECT_EQ(derived.m[2][0], 0.0) << "zbar is 0 at 700 nm";
}

// The functions as published in 1931 at 5 nm (transcribed from their reconstruction by Broadbent, 2009), to five
// decimals. The same four decimals of the chromaticities, times xbar + ybar + zbar of up to 1.8, are 9e-5.
TEST(CieRgbObserver, HasThePublishedFunctionsAndTheirNegativeLobes) {
    struct Row {
        double lambda_nm, r, g, b;
    };
    for (const Row& row : {Row{400.0, 0.00030, -0.00014, 0.01214}, Row{420.0, 0.00211, -0.00110, 0.11541},
                           Row{450.0, -0.01213, 0.00678, 0.31670}, Row{475.0, -0.04471, 0.03183, 0.18592},
                           Row{490.0, -0.05814, 0.05689, 0.08257}, Row{505.0, -0.08120, 0.10593, 0.03688},
                           Row{515.0, -0.09356, 0.15262, 0.01842}, Row{530.0, -0.07101, 0.20317, 0.00549},
                           Row{545.0, -0.00613, 0.21487, 0.00023}, Row{560.0, 0.09060, 0.19702, -0.00130},
                           Row{600.0, 0.34429, 0.06246, -0.00049}, Row{620.0, 0.29708, 0.01828, -0.00015},
                           Row{650.0, 0.10167, 0.00116, -0.00001}, Row{700.0, 0.00410, 0.0, 0.0}}) {
        const RGBd derived = eval(cie_rgb_1931(), row.lambda_nm);
        EXPECT_NEAR(derived.r, row.r, 9e-5) << row.lambda_nm;
        EXPECT_NEAR(derived.g, row.g, 9e-5) << row.lambda_nm;
        EXPECT_NEAR(derived.b, row.b, 9e-5) << row.lambda_nm;
    }
    const auto& value = cie_rgb_1931().value;
    const auto lowest = std::min_element(value.begin(), value.end(), [](RGBd a, RGBd b) { return a.r < b.r; });
    EXPECT_NEAR(static_cast<double>(lowest - value.begin()), 516.5 - cie_rgb_1931().first_nm, 2.0);
    for (double lambda_nm = 437.0; lambda_nm < 546.0; lambda_nm += 1.0) {
        EXPECT_LT(eval(cie_rgb_1931(), lambda_nm).r, 0.0) << lambda_nm;
    }
}

TEST(RgbObserver, RefusesPrimariesThatCantMatch) {
    EXPECT_THAT(
        [] {
            (void)rgb_observer(cie_1931_2deg(), {700.0, 350.0, 435.8});
        },
        ThrowsMessage<std::invalid_argument>(
            AllOf(HasSubstr("primaries_nm[1] = 350"), HasSubstr("from 360 to 830 nm"))));
    EXPECT_THROW((void)rgb_observer(cie_1931_2deg(), {700.0, NAN, 435.8}), std::invalid_argument);
    EXPECT_THROW((void)rgb_observer(cie_1931_2deg(), {700.0, 550.0, 550.0}), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
