#include "spectrum/cone_fundamentals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "spectrum/observer.h"

namespace emulsion {
namespace {

// Half a unit of the last of `digits` significant digits.
double rounding(double value, int digits) {
    if (value == 0.0) return 0.0;
    return 0.5 * std::pow(10.0, std::floor(std::log10(std::abs(value))) + 1.0 - digits);
}

// CIE 170-2:2015. The cones are tabulated to six digits, XYZ to seven: no more than that may be between them.
TEST(ConeFundamentals, GiveXyzOf2015ToTheLastDigit) {
    const ConeFundamentals& cones = stockman_sharpe_2deg();
    const Observer& observer = cie_2015_2deg();
    ASSERT_EQ(cones.first_nm, observer.first_nm);
    ASSERT_EQ(cones.value.size(), observer.value.size());
    const Matrix3 xyz_from_lms = xyz_2015_from_stockman_sharpe();
    for (std::size_t k = 0; k < cones.value.size(); ++k) {
        const std::array<double, 3> lms = {cones.value[k].l, cones.value[k].m, cones.value[k].s};
        const std::array<double, 3> xyz = {observer.value[k].x, observer.value[k].y, observer.value[k].z};
        const std::array<double, 3> transformed = xyz_from_lms * lms;
        for (std::size_t i = 0; i < 3; ++i) {
            double tolerance = rounding(xyz[i], 7);
            for (std::size_t j = 0; j < 3; ++j) tolerance += std::abs(xyz_from_lms.m[i][j]) * rounding(lms[j], 6);
            EXPECT_NEAR(transformed[i], xyz[i], tolerance) << "row " << i << " at " << 390 + k << " nm";
        }
    }
}

TEST(ConeFundamentals, PeakAtOne) {
    ConeSensitivities peak;
    for (const ConeSensitivities& value : stockman_sharpe_2deg().value) {
        peak = {std::max(peak.l, value.l), std::max(peak.m, value.m), std::max(peak.s, value.s)};
    }
    // The peaks lie between whole nm, up to half a nm away: second difference of the table at the peak, over 8.
    EXPECT_NEAR(peak.l, 1.0, 4.4e-4 / 8.0);
    EXPECT_NEAR(peak.m, 1.0, 1.2e-3 / 8.0);
    EXPECT_NEAR(peak.s, 1.0, 3.4e-3 / 8.0);
}

TEST(ConeFundamentals, AreStraightBetweenKnotsAndZeroOutside) {
    const ConeFundamentals& cones = stockman_sharpe_2deg();
    EXPECT_EQ(cones.last_nm(), 830);
    EXPECT_EQ(eval(cones, 390.0), cones.value.front());
    EXPECT_EQ(eval(cones, 830.0), cones.value.back());
    EXPECT_EQ(eval(cones, 389.999), ConeSensitivities{});
    EXPECT_EQ(eval(cones, 830.001), ConeSensitivities{});
    EXPECT_DOUBLE_EQ(eval(cones, 500.25).m, 0.75 * eval(cones, 500.0).m + 0.25 * eval(cones, 501.0).m);
    EXPECT_EQ(eval(cones, 616.0).s, 0.0) << "not tabulated there";
}

}  // namespace
}  // namespace emulsion
