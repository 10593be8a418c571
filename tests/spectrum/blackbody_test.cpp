#include "spectrum/blackbody.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/units.h"
#include "spectrum/colorimetry.h"
#include "spectrum/spectrum.h"

namespace emulsion {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Planck, IntegratesToStefanAndBoltzmann) {
    constexpr double kStefanBoltzmann = 5.670374419e-8;  // W m^-2 K^-4
    const double temperature_K = 3000.0;
    // Trapezoids in log(lambda), from 50 nm to 10 mm: the integrand vanishes at both ends, so they converge fast.
    double radiance = 0.0;
    const double step = 1e-3;
    for (double u = std::log(50.0); u < std::log(1e7); u += step) {
        const double lambda_nm = std::exp(u);
        radiance += planck_radiance(temperature_K, lambda_nm) * lambda_nm * step;
    }
    const double expected = kStefanBoltzmann * std::pow(temperature_K, 4.0) / kPi;
    EXPECT_NEAR(radiance / expected, 1.0, 1e-7);
}

double blackbody_luminance(double temperature_K) {
    return xyz_of_radiance(BlackbodySpectrum{temperature_K, BlackbodyUnit::radiance}).y;
}

TEST(Planck, LuminanceAt2042KelvinIsThePublishedOne) {
    EXPECT_NEAR(blackbody_luminance(2042.0), 5.986e5, 0.0005e5);

    // The second radiation constant c2 was 1.4388e-2 m K in older scales: exp(c2/(lambda T)) is then that of the
    // temperature T c2(SI)/c2, and the luminance a fifth of a thousandth less.
    const double si_c2 = kPlanck * kSpeedOfLight / kBoltzmann;
    EXPECT_NEAR(blackbody_luminance(2042.0 * si_c2 / 1.4388e-2), 5.98478e5, 5.0);
}

TEST(Planck, RelativeFormIsTheAbsoluteOneOverItsPeak) {
    for (const double temperature_K : {500.0, 2042.0, 6504.0, 40000.0}) {
        const double peak_nm = 2.897771955e6 / temperature_K;
        const double peak = planck_radiance(temperature_K, peak_nm);
        EXPECT_NEAR(relative_planck_radiance(temperature_K, peak_nm), 1.0, 1e-14);
        EXPECT_LT(relative_planck_radiance(temperature_K, 1.001 * peak_nm), 1.0);
        EXPECT_LT(relative_planck_radiance(temperature_K, 0.999 * peak_nm), 1.0);
        for (const double lambda_nm : {360.0, 555.0, 830.0}) {
            const double expected = planck_radiance(temperature_K, lambda_nm) / peak;
            EXPECT_NEAR(relative_planck_radiance(temperature_K, lambda_nm), expected, 1e-12 * expected);
        }
    }
}

TEST(Blackbody, ComesInBothUnits) {
    for (const double lambda_nm : {300.0, 555.0, 10000.0}) {
        EXPECT_EQ(eval(BlackbodySpectrum{3000.0}, lambda_nm), relative_planck_radiance(3000.0, lambda_nm));
        EXPECT_EQ(eval(BlackbodySpectrum{3000.0, BlackbodyUnit::radiance}, lambda_nm),
                  planck_radiance(3000.0, lambda_nm));
    }
}

TEST(Planck, FarFromThePeakIsZeroNotNaN) {
    EXPECT_EQ(planck_radiance(1.0, 360.0), 0.0);
    EXPECT_EQ(relative_planck_radiance(1.0, 360.0), 0.0);
    EXPECT_EQ(eval(BlackbodySpectrum{1.0}, 360.0), 0.0);
    EXPECT_EQ(eval(BlackbodySpectrum{1e308}, 500.0), 0.0) << "500 nm times 1e308 K is no double";
}

// Rayleigh and Jeans: 2 c k T / lambda^4, up to temperatures that are near a double's end.
TEST(Planck, OfTheHottestIsThatOfRayleighAndJeans) {
    for (const double temperature_K : {1e16, 1e100, 1e300}) {
        const double expected = 1e-9 * 2.0 * kSpeedOfLight * kBoltzmann * temperature_K / std::pow(5e-7, 4.0);
        EXPECT_NEAR(planck_radiance(temperature_K, 500.0) / expected, 1.0, 1e-11) << temperature_K;
    }
}

}  // namespace
}  // namespace emulsion
