#include "spectrum/photometry.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/units.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

Spectrum line_at(double lambda_nm, double power = 1.0) { return LineSpectrum{{{lambda_nm, power}}, {}}; }

TEST(PhotometricQuantities, ArePairs) {
    EXPECT_EQ(kPhotometricQuantities.size(), 5u);
    for (const PhotometricQuantity& pair : kPhotometricQuantities) {
        // The geometry stays: the units differ in W and lm only.
        ASSERT_EQ(pair.radiometric_unit.substr(0, 1), "W");
        ASSERT_EQ(pair.photometric_unit.substr(0, 2), "lm");
        EXPECT_EQ(pair.radiometric_unit.substr(1), pair.photometric_unit.substr(2)) << pair.radiometric;
    }
}

TEST(Photometry, PeaksAtThePublishedEfficacies) {
    // The definition of the candela, but for 555.016 in place of 555 nm; V'(507) = 1 (CIE 1951).
    EXPECT_DOUBLE_EQ(luminous_flux_lm(line_at(555.0)), 683.0);
    EXPECT_DOUBLE_EQ(luminous_flux_lm(line_at(507.0), scotopic()), 1700.0);
    // V(510) = 0.503, V'(510) = 0.997, V'(555) = 0.402 (CIE tables).
    EXPECT_NEAR(luminous_flux_lm(line_at(510.0)), 683.0 * 0.503, 1e-9);
    EXPECT_NEAR(luminous_flux_lm(line_at(510.0), scotopic()), 1700.0 * 0.997, 1e-9);
    EXPECT_NEAR(luminous_flux_lm(line_at(555.0), scotopic()), 1700.0 * 0.402, 1e-9);
    EXPECT_EQ(luminous_flux_lm(line_at(900.0)), 0.0);
    EXPECT_EQ(luminous_flux_lm(line_at(370.0), scotopic()), 0.0);
}

TEST(Photometry, ScotopicEfficacyFollowsFromTheCandela) {
    // 540 THz are 555.016 nm in air, where both efficacies are 683 lm/W: 1700 is that, rounded.
    EXPECT_NEAR(kLuminousEfficacy / eval(scotopic().relative, 555.016), 1700.06, 0.005);
}

TEST(Photometry, OneFormulaForAllQuantities) {
    const Spectrum lamp = sum_of(tabulated_spectrum("illuminants_5nm", "FL11"), line_at(546.074, 30.0), 2.0);
    const double expected = xyz_of_radiance(lamp).y;
    for (const double value : {luminous_flux_lm(lamp), luminous_intensity_cd(lamp), illuminance_lux(lamp),
                               luminous_exitance_lm_m2(lamp), luminance_nit(lamp), photometric_value(lamp)}) {
        EXPECT_NEAR(value / expected, 1.0, 1e-12) << "V and ybar differ in their last digits";
    }
}

TEST(Photometry, TakesTheEyeOfAnyObserver) {
    const Spectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    const double expected = xyz_of_radiance(d65, cie_1964_10deg()).y;
    EXPECT_NEAR(luminance_nit(d65, photopic(cie_1964_10deg())) / expected, 1.0, 1e-13);
    EXPECT_GT(expected, 1.05 * luminance_nit(d65)) << "the wider field sees more blue";
    const Observer narrow{"two lines", 400, {{0, 1, 0}, {0, 1, 0}, {0, 0, 0}}};
    EXPECT_NEAR(luminous_flux_lm(ConstantSpectrum{1.0}, photopic(narrow)), 683.0 * 1.5, 1e-10);
}

TEST(Photometry, OfAConstantIsTheSumOfTheTable) {
    double sum = 0.0;
    const std::vector<double>& v = scotopic().relative.value;
    for (const double value : v) sum += value;
    EXPECT_NEAR(luminance_nit(ConstantSpectrum{1.0}, scotopic()), 1700.0 * (sum - 0.5 * (v.front() + v.back())), 1e-8);
}

// A blackbody at the freezing point of platinum was the standard of the candela until 1979: 60 cd/cm^2 at 2042 K.
TEST(Photometry, PlatinumPointIsThePublishedOne) {
    EXPECT_NEAR(luminance_nit(BlackbodySpectrum{2042.0, BlackbodyUnit::radiance}), 5.986e5, 0.0005e5);
}

TEST(Photometry, RefusesWhatIsOutOfRange) {
    EXPECT_THROW((void)luminous_flux_lm(BlackbodySpectrum{0.0}), std::invalid_argument);
    EXPECT_THROW((void)photometric_value(ConstantSpectrum{1.0}, {photopic().relative, 0.0}), std::invalid_argument);
    EXPECT_THROW((void)photometric_value(ConstantSpectrum{1.0}, {PiecewiseLinearSpectrum{}, 683.0}),
                 std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
