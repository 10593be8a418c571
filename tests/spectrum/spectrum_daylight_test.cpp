#include "spectrum/spectrum_daylight.h"

#include <cmath>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/spectrum.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

struct Nominal {
    const char* name;
    double nominal_K;
};
constexpr Nominal kNominals[] = {{"D50", 5000.0}, {"D55", 5500.0}, {"D65", 6500.0}, {"D75", 7500.0}};

double largest_difference_from_table(const char* name, const DaylightSpectrum& daylight) {
    double largest = 0.0;
    const PiecewiseLinearSpectrum table = tabulated_spectrum("illuminants_a_d_300_830_5nm", name);
    for (std::size_t i = 0; i < table.lambda_nm.size(); ++i) {
        largest = std::max(largest, std::abs(eval(daylight, table.lambda_nm[i]) - table.value[i]));
    }
    return largest;
}

TEST(Daylight, GivesThePublishedTables) {
    for (const auto& [name, nominal_K] : kNominals) {
        const double temperature_K = daylight_temperature_of_nominal(nominal_K);
        // The tables have three decimals (D65 four, halves between them rounded): 100 at 560 nm.
        EXPECT_LE(largest_difference_from_table(name, {temperature_K}), 1e-3) << name;
        // Without the rounding of M1 and M2 they aren't met; that is what the rounding is for.
        const double exact = largest_difference_from_table(name, {temperature_K, DaylightWeights::exact});
        EXPECT_GT(exact, 5e-3) << name;
        EXPECT_LT(exact, 2e-2) << name;
    }
    // The same with the whole kelvins that are usually quoted: M1 of 6504 K rounds the other way.
    EXPECT_NEAR(largest_difference_from_table("D65", {6504.0}), 0.046, 0.001);
    EXPECT_EQ(DaylightSpectrum{}.temperature_K, daylight_temperature_of_nominal(6500.0));
}

TEST(Daylight, NominalTemperaturesAreThoseOfAnOlderScale) {
    // CIE 15:2004, section 3.1, note: 5003, 5503, 6504, 7504 K.
    EXPECT_EQ(std::round(daylight_temperature_of_nominal(5000.0)), 5003.0);
    EXPECT_EQ(std::round(daylight_temperature_of_nominal(5500.0)), 5503.0);
    EXPECT_EQ(std::round(daylight_temperature_of_nominal(6500.0)), 6504.0);
    EXPECT_EQ(std::round(daylight_temperature_of_nominal(7500.0)), 7504.0);
}

TEST(Daylight, HasTheChromaticityOfTheLocus) {
    for (double temperature_K = 4000.0; temperature_K <= 25000.0; temperature_K *= 1.07) {
        const Chromaticity expected = daylight_chromaticity(temperature_K);
        const Chromaticity exact =
            chromaticity_of(xyz_of_radiance(DaylightSpectrum{temperature_K, DaylightWeights::exact}));
        // The formulas for M1 and M2 miss y by 1e-4, as is known from D65 itself: (0.31272, 0.32903) by its table (CIE
        // 15:2004, table T.3) and (0.31272, 0.32913) by the locus.
        EXPECT_NEAR(exact.x, expected.x, 4e-5) << temperature_K;
        EXPECT_NEAR(exact.y, expected.y - 1e-4, 4e-5) << temperature_K;
    }
}

TEST(Daylight, LocusIsThePublishedOne) {
    // x of the cubics worked by hand at 1/T = 2.5e-4, 1e-4 and 4e-5, y by the parabola.
    EXPECT_NEAR(daylight_chromaticity(4000.0).x, -4.6070 / 64.0 + 2.9678 / 16.0 + 0.02477750 + 0.244063, 1e-15);
    EXPECT_NEAR(daylight_chromaticity(10000.0).x, -0.0020064 + 0.019018 + 0.024748 + 0.237040, 1e-15);
    EXPECT_NEAR(daylight_chromaticity(25000.0).x,
                -2.0064e9 / 1.5625e13 + 1.9018e6 / 6.25e8 + 0.24748e3 / 25000.0 + 0.237040, 1e-15);
    const double x = daylight_chromaticity(5200.0).x;
    EXPECT_NEAR(daylight_chromaticity(5200.0).y, -3.0 * x * x + 2.87 * x - 0.275, 1e-15);
    // At 7000 K the two cubics meet but for 4.64e-7 (worked by hand).
    EXPECT_NEAR(daylight_chromaticity(7000.0).x - daylight_chromaticity(std::nextafter(7000.0, 8000.0)).x, 4.64e-7,
                1e-9);
}

TEST(Daylight, JumpsAtTheEndsOfItsTables) {
    const DaylightSpectrum d65;
    EXPECT_EQ(eval(d65, 299.99), 0.0);
    EXPECT_EQ(eval(d65, 830.01), 0.0);
    EXPECT_GT(eval(d65, 830.0), 50.0);
    EXPECT_EQ(limit(d65, 830.0, Side::above), 0.0);
    EXPECT_EQ(limit(d65, 830.0, Side::below), eval(d65, 830.0));
    EXPECT_EQ(limit(d65, 300.0, Side::below), 0.0);
    EXPECT_EQ(knots_nm(d65).size(), 107u);
}

TEST(Daylight, EndsWithItsRange) {
    EXPECT_NO_THROW(validate(DaylightSpectrum{4000.0}));
    EXPECT_NO_THROW(validate(DaylightSpectrum{25000.0}));
    for (const double temperature_K : {3999.9, 25000.1, std::nan("")}) {
        EXPECT_THAT([=] { validate(DaylightSpectrum{temperature_K}); },
                    ThrowsMessage<std::invalid_argument>(HasSubstr("temperature_K")));
        EXPECT_THROW((void)daylight_chromaticity(temperature_K), std::invalid_argument);
    }
}

}  // namespace
}  // namespace emulsion
