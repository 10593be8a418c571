#include "spectrum/colorimetry.h"

#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.h"
#include "spectrum/data_table.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr const char* kIlluminants = "illuminants_a_d_300_830_5nm";

double sum_of_ybar() {
    double sum = 0.0;
    for (const XYZd& value : cie_1931_2deg().value) sum += value.y;
    return sum;
}

// The integral of ybar by trapezoids, which straight lines between the 1 nm values make exact.
double integral_of_ybar() {
    const auto& value = cie_1931_2deg().value;
    return sum_of_ybar() - 0.5 * (value.front().y + value.back().y);
}

// A brute-force twin: the mid-point rule, 1/1024 nm apart.
double fine_photometric_integral(const Spectrum& spectrum) {
    constexpr double kStep_nm = 0x1p-10;
    double sum = 0.0;
    for (double lambda_nm = 360.0 + 0.5 * kStep_nm; lambda_nm < 830.0; lambda_nm += kStep_nm) {
        sum += eval(spectrum, lambda_nm) * eval(cie_1931_2deg(), lambda_nm).y;
    }
    return kStep_nm * sum;
}

TEST(Observer, HasThePublishedSum) {
    EXPECT_EQ(cie_1931_2deg().first_nm, 360);
    EXPECT_EQ(cie_1931_2deg().last_nm(), 830);
    EXPECT_NEAR(sum_of_ybar(), 106.856917, 5e-7);
}

TEST(Observer, IsStraightBetweenKnotsAndZeroOutside) {
    const Observer& observer = cie_1931_2deg();
    EXPECT_EQ(eval(observer, 360.0), observer.value.front());
    EXPECT_EQ(eval(observer, 830.0), observer.value.back());
    EXPECT_EQ(eval(observer, 359.999), XYZd{});
    EXPECT_EQ(eval(observer, 830.001), XYZd{});
    EXPECT_EQ(eval(observer, 555.0).y, 1.0);
    EXPECT_DOUBLE_EQ(eval(observer, 600.25).x, 0.75 * eval(observer, 600.0).x + 0.25 * eval(observer, 601.0).x);
}

TEST(PhotometricIntegral, OfConstantsAndLinesIsExact) {
    const double expected = integral_of_ybar();
    EXPECT_NEAR(photometric_integral(ConstantSpectrum{2.0}), 2.0 * expected, 1e-12 * expected);
    EXPECT_NEAR(photometric_integral(PiecewiseLinearSpectrum{{300.0, 900.0}, {2.0, 2.0}}), 2.0 * expected,
                1e-12 * expected);

    // A ramp from a knot at half a nanometre: integrate the product of the two lines by hand.
    const PiecewiseLinearSpectrum ramp{{555.25, 555.75}, {0.0, 1.0}};
    const double y0 = eval(cie_1931_2deg(), 555.25).y, y1 = eval(cie_1931_2deg(), 555.75).y;
    EXPECT_NEAR(photometric_integral(ramp), 0.5 * (y0 / 6.0 + y1 / 3.0), 1e-15);
}

TEST(PhotometricIntegral, CutsAtTheEndsOfATable) {
    // 1 on [500, 501] and 0 elsewhere: nothing of the neighbouring nanometres may leak in.
    const PiecewiseLinearSpectrum pulse{{500.0, 501.0}, {1.0, 1.0}};
    EXPECT_NEAR(photometric_integral(pulse), 0.5 * (eval(cie_1931_2deg(), 500.0).y + eval(cie_1931_2deg(), 501.0).y),
                1e-15);
}

TEST(PhotometricIntegral, OfSmoothSpectraMatchesAFineSum) {
    const PiecewiseLinearSpectrum d65 = tabulated_spectrum(kIlluminants, "D65");
    const SigmoidSpectrum gentle{{8.0, -6.0, 0.3}}, steep{{40.0, 900.0, -400.0}};
    const std::vector<Spectrum> spectra = {BlackbodySpectrum{2042.0}, BlackbodySpectrum{20000.0}, gentle, steep,
                                           RgbIlluminantSpectrum{steep, d65, 3.0}};
    for (const Spectrum& spectrum : spectra) {
        const double expected = fine_photometric_integral(spectrum);
        EXPECT_NEAR(photometric_integral(spectrum), expected, 1e-9 * expected) << spectrum.index();
    }
}

TEST(LightNormalisation, IsThatOfTheIlluminantForRgbLights) {
    const PiecewiseLinearSpectrum d65 = tabulated_spectrum(kIlluminants, "D65");
    const RgbIlluminantSpectrum red{SigmoidSpectrum{{20.0, 0.0, -10.0}}, d65, 2.0};
    EXPECT_EQ(light_normalisation(red), photometric_integral(d65));
    EXPECT_EQ(light_normalisation(d65), photometric_integral(d65));
    EXPECT_EQ(light_normalisation(PiecewiseLinearSpectrum{{900.0, 950.0}, {1.0, 1.0}}), 0.0);
}

TEST(LightNormalisation, GivesALightTheLuminanceOfItsScale) {
    const std::vector<Spectrum> spectra = {tabulated_spectrum("illuminants_5nm", "FL11"), BlackbodySpectrum{3000.0},
                                           tabulated_spectrum("cornell_box", "light_emission")};
    for (const Spectrum& spectrum : spectra) {
        const double factor = 17.0 / (kLuminousEfficacy * light_normalisation(spectrum));
        EXPECT_NEAR(factor * xyz_of_radiance(spectrum).y, 17.0, 1e-11);
    }
}

TEST(XyzOfRadiance, IsAbsolute) {
    const XYZd xyz = xyz_of_radiance(ConstantSpectrum{1.0});
    EXPECT_NEAR(xyz.y, 683.0 * integral_of_ybar(), 1e-8);
    EXPECT_NEAR(xyz.x / (xyz.x + xyz.y + xyz.z), 1.0 / 3.0, 1e-4) << "equal energy is nearly white";
}

TEST(XyzOfRadiance, GivesThePublishedWhitePoints) {
    struct Case {
        const char* name;
        double x, y;
    };
    // CIE 15:2004, table T.3.
    for (const Case& c : {Case{"A", 0.44758, 0.40745}, Case{"D50", 0.34567, 0.35851}, Case{"D65", 0.31272, 0.32903}}) {
        const XYZd xyz = xyz_of_radiance(tabulated_spectrum(kIlluminants, c.name));
        const double sum = xyz.x + xyz.y + xyz.z;
        EXPECT_NEAR(xyz.x / sum, c.x, 3e-5) << c.name;
        EXPECT_NEAR(xyz.y / sum, c.y, 3e-5) << c.name;
    }
}

TEST(XyzOfReflectance, IsRelativeToThePerfectReflector) {
    const PiecewiseLinearSpectrum d65 = tabulated_spectrum(kIlluminants, "D65");
    const XYZd white = xyz_of_reflectance(ConstantSpectrum{1.0}, d65),
               grey = xyz_of_reflectance(ConstantSpectrum{0.25}, d65);
    EXPECT_NEAR(white.y, 1.0, 1e-14);
    EXPECT_NEAR(grey.x, 0.25 * white.x, 1e-14);
    EXPECT_NEAR(grey.z, 0.25 * white.z, 1e-14);
}

TEST(XyzOfReflectance, NeedsLight) {
    const PiecewiseLinearSpectrum infrared{{900.0, 950.0}, {1.0, 1.0}};
    EXPECT_THAT([&] { (void)xyz_of_reflectance(ConstantSpectrum{1.0}, infrared); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("illuminant: its luminance is 0")));
    // Integrals that overflow, or whose reciprocal does, would make XYZ of NaN or infinity.
    EXPECT_THAT([] { (void)xyz_of_reflectance(ConstantSpectrum{0.5}, ConstantSpectrum{1e307}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("luminance is inf")));
    EXPECT_THROW((void)xyz_of_reflectance(ConstantSpectrum{0.5}, ConstantSpectrum{1e-312}), std::invalid_argument);
    EXPECT_THROW((void)xyz_by_summation(ConstantSpectrum{0.5}, ConstantSpectrum{1e307}), std::invalid_argument);
    EXPECT_THROW((void)xyz_of_radiance(BlackbodySpectrum{-1.0}), std::invalid_argument);
    EXPECT_THROW((void)photometric_integral(PiecewiseLinearSpectrum{}), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
