#include "spectrum/lms.h"

#include <cstddef>
#include <utility>

#include <gtest/gtest.h>

#include "spectrum/cone_fundamentals.h"
#include "spectrum/observer.h"

namespace emulsion {
namespace {

void expect_near(const Matrix3& matrix, const Matrix3& expected, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(matrix.m[i][j], expected.m[i][j], tolerance) << "row " << i << ", column " << j;
        }
    }
}

// The inverses are in print, too: digits that don't depend on the matrices that we have typed in.
TEST(Lms, MatricesHaveThePublishedInverses) {
    // CIE 159:2004, section 4: HPE and CAT02 to six decimals.
    expect_near(inverse(LmsHpeSystem::lms_from_xyz()),
                {{{{1.910197, -1.112124, 0.201908}, {0.370950, 0.629054, -0.000008}, {0.0, 0.0, 1.0}}}}, 5.1e-7);
    expect_near(inverse(LmsCat02System::lms_from_xyz()),
                {{{{1.096124, -0.278869, 0.182745}, {0.454369, 0.473533, 0.072098}, {-0.009628, -0.005698, 1.015326}}}},
                5.1e-7);
    // Lindbloom's page on adaptation, to seven decimals.
    expect_near(
        inverse(LmsBradfordSystem::lms_from_xyz()),
        {{{{0.9869929, -0.1470543, 0.1599627}, {0.4323053, 0.5183603, 0.0492912}, {-0.0085287, 0.0400428, 0.9684867}}}},
        5.1e-8);
    // Li et al. 2017, to eight decimals, cut off and not rounded.
    expect_near(inverse(LmsCat16System::lms_from_xyz()),
                {{{{1.86206786, -1.01125463, 0.14918677},
                   {0.38752654, 0.62144744, -0.00897398},
                   {-0.01584150, -0.03412294, 1.04996444}}}},
                1e-8);
}

// All four are normalised to the equal-energy white, as far as their digits go.
TEST(Lms, OfTheEqualEnergyWhiteIsGrey) {
    for (const auto& [matrix, tolerance] :
         {std::pair{LmsHpeSystem::lms_from_xyz(), 1.1e-5}, std::pair{LmsBradfordSystem::lms_from_xyz(), 1.1e-4},
          std::pair{LmsCat02System::lms_from_xyz(), 1e-15}, std::pair{LmsCat16System::lms_from_xyz(), 1e-15}}) {
        const Lms white = lms_of(matrix, {1.0, 1.0, 1.0});
        EXPECT_NEAR(white.l, 1.0, tolerance);
        EXPECT_NEAR(white.m, 1.0, tolerance);
        EXPECT_NEAR(white.s, 1.0, tolerance);
    }
}

// The tabulated cones and CIE 2015 colour-matching functions, of seven and six digits: at each nanometre from the
// functions to the cones.
TEST(Lms, OfTheCie2015FunctionsAreTheCones) {
    const Matrix3 lms_from_xyz = LmsCie2015System::lms_from_xyz();
    for (int lambda_nm = 390; lambda_nm <= 830; ++lambda_nm) {
        const ConeSensitivities cones = eval(stockman_sharpe_2deg(), lambda_nm);
        const Lms lms = lms_of(lms_from_xyz, eval(cie_2015_2deg(), lambda_nm));
        EXPECT_NEAR(lms.l, cones.l, 1e-6) << lambda_nm;
        EXPECT_NEAR(lms.m, cones.m, 1e-6) << lambda_nm;
        EXPECT_NEAR(lms.s, cones.s, 1e-6) << lambda_nm;
    }
}

TEST(Lms, IsLinear) {
    const Lms one = lms_of(LmsCat16System::lms_from_xyz(), {0.2, 0.3, 0.4}),
              hundred = lms_of(LmsCat16System::lms_from_xyz(), {20.0, 30.0, 40.0});
    EXPECT_DOUBLE_EQ(hundred.l, 100.0 * one.l);
    EXPECT_DOUBLE_EQ(hundred.m, 100.0 * one.m);
    EXPECT_DOUBLE_EQ(hundred.s, 100.0 * one.s);
}

}  // namespace
}  // namespace emulsion
