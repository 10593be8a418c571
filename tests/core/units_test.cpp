#include "core/units.h"

#include <gtest/gtest.h>

namespace emulsion {
namespace {

TEST(Units, CombineToThePublishedConstants) {
    // CODATA 2018: second radiation constant hc/k = 1.438776877e-2 m K, in the ten digits printed.
    EXPECT_NEAR(kPlanck * kSpeedOfLight / kBoltzmann, 1.438776877e-2, 1e-11);
    // The candela is defined at 540 THz, 555.17 nm in vacuum: inside the range that rendering covers.
    const double wavelength_nm = kSpeedOfLight / 540e12 * 1e9;
    EXPECT_GT(wavelength_nm, kMinWavelength_nm);
    EXPECT_LT(wavelength_nm, kMaxWavelength_nm);
    EXPECT_EQ(kLuminousEfficacy, 683.0);
}

}  // namespace
}  // namespace emulsion
