#include "spectrum/spectrum_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.h"
#include "spectrum/colorimetry.h"
#include "spectrum/data_table.h"
#include "spectrum/observer.h"
#include "spectrum/rgb_uplift.h"

namespace emulsion {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

float at(const SpectrumTable& table, double lambda_nm) {
    return table.at(SpectrumTableIndex<1>({static_cast<float>(lambda_nm)}))[0];
}

// Largest difference from eval over the range, but for the jumps themselves, over the largest value.
double largest_relative_difference(const Spectrum& spectrum) {
    const SpectrumTable table(spectrum);
    double difference = 0.0, largest = 0.0;
    for (double lambda_nm = 360.03125; lambda_nm < 830.0; lambda_nm += 0.0625) {
        const double expected = eval(spectrum, lambda_nm);
        difference = std::max(difference, std::abs(static_cast<double>(at(table, lambda_nm)) - expected));
        largest = std::max(largest, std::abs(expected));
    }
    return difference / largest;
}

TEST(SpectrumTable, IsExactForWholeNanometreKnots) {
    EXPECT_LE(largest_relative_difference(ConstantSpectrum{0.7}), 1e-6);
    EXPECT_LE(largest_relative_difference(tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65")), 1e-6);
    EXPECT_LE(largest_relative_difference(tabulated_spectrum("illuminants_5nm", "FL11")), 1e-6);
    for (const char* column : {"white", "green", "red", "light_emission"}) {
        EXPECT_LE(largest_relative_difference(tabulated_spectrum("cornell_box", column)), 1e-6) << column;
    }
}

TEST(SpectrumTable, KeepsTheJumpsAtTheEndsOfATable) {
    const SpectrumTable table(PiecewiseLinearSpectrum{{400.0, 700.0}, {2.0, 4.0}});
    EXPECT_EQ(at(table, 399.5), 0.0f);
    EXPECT_EQ(at(table, 399.9999), 0.0f);
    EXPECT_EQ(at(table, 400.0), 2.0f);
    EXPECT_NEAR(at(table, 400.5), 2.0f + 0.5f / 150.0f, 1e-6f);
    EXPECT_NEAR(at(table, 699.9999), 4.0f, 1e-5f);
    EXPECT_EQ(at(table, 700.0001), 0.0f);
    EXPECT_EQ(at(table, 700.5), 0.0f);
}

TEST(SpectrumTable, CoversTheEndsOfTheRange) {
    const SpectrumTable table(PiecewiseLinearSpectrum{{300.0, 900.0}, {0.0, 600.0}});
    EXPECT_FLOAT_EQ(at(table, 360.0), 60.0f);
    EXPECT_FLOAT_EQ(at(table, 830.0), 530.0f);
}

TEST(SpectrumTable, FollowsSmoothSpectra) {
    // A straight line per nanometre is off by h^2/8 of the second derivative.
    EXPECT_LE(largest_relative_difference(BlackbodySpectrum{2042.0}), 3e-5);
    EXPECT_LE(largest_relative_difference(BlackbodySpectrum{6504.0}), 1e-5);
    const RgbSpace& space = rgb_space("sRGB");
    for (const RGBd& rgb : {RGBd{0.8, 0.1, 0.05}, RGBd{0.1, 0.6, 0.2}, RGBd{0.02, 0.1, 0.9}, RGBd{0.3, 0.4, 0.5}}) {
        EXPECT_LE(largest_relative_difference(fit_sigmoid(rgb, space)), 2e-3) << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
        EXPECT_LE(largest_relative_difference(rgb_illuminant(rgb, space)), 2e-3)
            << rgb.r << ' ' << rgb.g << ' ' << rgb.b;
    }
}

// Integral of the table times one of the observer's functions: both are straight lines between whole nanometres.
XYZd xyz_of_table(const SpectrumTable& table) {
    XYZd sum;
    for (int lambda_nm = 360; lambda_nm < 830; ++lambda_nm) {
        // Values at 1/4 and 3/4 give the line; Simpson's rule is exact for the product of two lines.
        const auto low = static_cast<double>(at(table, lambda_nm + 0.25));
        const auto high = static_cast<double>(at(table, lambda_nm + 0.75));
        const double start = 1.5 * low - 0.5 * high, end = 1.5 * high - 0.5 * low;
        const auto observer = [&](double t) { return eval(cie_1931_2deg(), lambda_nm + t); };
        sum = sum + (start / 6.0) * observer(0.0) + ((start + end) / 3.0) * observer(0.5) + (end / 6.0) * observer(1.0);
    }
    return sum;
}

TEST(SpectrumTable, LinesBetweenWholeNanometresAreAsBrightAsTheyShouldBe) {
    for (const double half_width_nm : {1e-4, 0.01, 0.1, 0.3, 0.5, 0.8, 3.3}) {
        for (double centre_nm = 400.0; centre_nm < 720.0; centre_nm += 3.137) {
            const Spectrum line = PiecewiseLinearSpectrum{
                {centre_nm - half_width_nm, centre_nm, centre_nm + half_width_nm}, {0.0, 1.0, 0.0}};
            const double expected = photometric_integral(line);
            EXPECT_NEAR(xyz_of_table(SpectrumTable(line, 1.0 / expected)).y, 1.0, 1e-5)
                << centre_nm << " nm, " << half_width_nm;
        }
    }
}

TEST(SpectrumTable, TakesEveryKindOfSpectrum) {
    const Spectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    EXPECT_LE(largest_relative_difference(DenseSpectrum{400.0, 5.0, {1.0, 0.0, 2.0, 3.0}}), 1e-6);
    EXPECT_LE(largest_relative_difference(PiecewiseLinearSpectrum{{500.0, 600.0}, {1.0, 2.0}, Extrapolation::straight}),
              1e-6);
    EXPECT_LE(largest_relative_difference(DaylightSpectrum{5000.0}), 1e-6);
    EXPECT_LE(largest_relative_difference(BlackbodySpectrum{2856.0, BlackbodyUnit::radiance}), 3e-5);
    EXPECT_LE(largest_relative_difference(sum_of(d65, DaylightSpectrum{5000.0}, 0.5, 2.0)), 1e-6);
    // Next to the peak, 1 - d t^2/2 with d = 1/sigma^2 = 1/33.8, the nearest line would start above 1. Pulled down to
    // it with the mean 1 - d/6 kept, it is 1 - d t/3, and d/6 too high at the other end.
    EXPECT_LE(largest_relative_difference(LineSpectrum{{}, {{550.0, 13.7, 1.0}}}), 1.0 / 6.0 / 33.8);
    // Elsewhere a parabola's nearest line is off by h^2/12 of the second derivative.
    const Spectrum ramp = PiecewiseLinearSpectrum{{360.0, 830.0}, {0.0, 1.0}};
    EXPECT_LE(largest_relative_difference(product_of(ramp, ramp)), 2.0 / 12.0 / (470.0 * 470.0) + 1e-6);
}

TEST(SpectrumTable, LinesWithoutWidthAreAsBrightAsTheyShouldBe) {
    const Spectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    for (const double power : {3.0, -3.0}) {
        for (const double lambda_nm : {360.0, 435.833, 500.0, 500.01, 546.074, 611.5, 779.99, 829.7, 830.0}) {
            const Spectrum line = LineSpectrum{{{lambda_nm, power}}, {}};
            const double expected = power * eval(cie_1931_2deg(), lambda_nm).y;
            EXPECT_NEAR(photometric_integral(line) / expected, 1.0, 1e-14);
            const SpectrumTable table(line, 1.0 / expected);
            EXPECT_NEAR(xyz_of_table(table).y, 1.0, 1e-6) << lambda_nm;
            // Of one sign, in its own nanometre only, and added to what else is there.
            const double cell_nm = std::min(std::floor(lambda_nm), 829.0);
            for (const double inside : {0.01, 0.5, 0.99})
                EXPECT_GE(at(table, cell_nm + inside) * eval(cie_1931_2deg(), lambda_nm).y, -1e-6f);
            if (cell_nm > 360.0) {
                EXPECT_EQ(at(table, cell_nm - 0.01), 0.0f);
            }
            const SpectrumTable lamp(sum_of(d65, line)), alone(d65), weak(line);
            EXPECT_NEAR(at(lamp, cell_nm + 0.3), at(alone, cell_nm + 0.3) + at(weak, cell_nm + 0.3), 2e-5f);
        }
    }
    // In the middle third of a nanometre X and Z are kept, too; two lines in one nanometre are both there.
    const Spectrum two = LineSpectrum{{{450.4, 1.0}, {450.6, 2.0}}, {}};
    const XYZd found = xyz_of_table(SpectrumTable(two)), expected = (1.0 / kLuminousEfficacy) * xyz_of_radiance(two);
    EXPECT_NEAR(found.x / expected.x, 1.0, 1e-6);
    EXPECT_NEAR(found.y / expected.y, 1.0, 1e-6);
    EXPECT_NEAR(found.z / expected.z, 1.0, 1e-6);
    // Outside the wavelengths of rendering there is nothing to add to.
    EXPECT_EQ(xyz_of_table(SpectrumTable(LineSpectrum{{{359.9, 1.0}, {830.1, 1.0}}, {}})).y, 0.0);
}

TEST(SpectrumTable, GaussiansAreAsBrightAsTheyShouldBe) {
    for (const double fwhm_nm : {1e-6, 1e-3, 0.1, 0.7, 2.0, 5.0, 30.0}) {
        for (double mean_nm = 400.0; mean_nm < 720.0; mean_nm += 31.37) {
            const Spectrum line = LineSpectrum{{}, {{mean_nm, fwhm_nm, 1.0}}};
            const double expected = photometric_integral(line);
            EXPECT_NEAR(xyz_of_table(SpectrumTable(line, 1.0 / expected)).y, 1.0, 1e-5) << mean_nm << ' ' << fwhm_nm;
        }
    }
}

TEST(SpectrumTable, SteepSigmoidsAreAsBrightAsTheyShouldBe) {
    // An edge at 500.3 nm, and a bump of 0.005 nm there.
    const double t = 140.3 / 470.0, k = 1e10;
    const SigmoidSpectrum edge{{0.0, 1e7, -1e7 * t}}, bump{{-k, 2.0 * k * t, -k * t * t}};
    for (const SigmoidSpectrum& steep : {edge, bump}) {
        const double expected = photometric_integral(steep);
        EXPECT_NEAR(xyz_of_table(SpectrumTable(steep, 1.0 / expected)).y, 1.0, 1e-5);
    }
}

TEST(SpectrumTable, KnotsBetweenWholeNanometresKeepTheColour) {
    // Where the line nearest to the spectrum stays between 0 and 1, all three sums are exact; else nearly so.
    const Spectrum spectrum = PiecewiseLinearSpectrum{{420.3, 480.71, 530.5, 531.2, 590.9, 655.45, 690.1},
                                                      {0.2, 0.8, 0.3, 0.35, 1.0, 0.1, 0.7}};
    const XYZd expected = xyz_of_radiance(spectrum), found = kLuminousEfficacy * xyz_of_table(SpectrumTable(spectrum));
    EXPECT_NEAR(found.x / expected.x, 1.0, 1e-5);
    EXPECT_NEAR(found.y / expected.y, 1.0, 1e-6);
    EXPECT_NEAR(found.z / expected.z, 1.0, 1e-5);
}

TEST(SpectrumTable, FitsTheLineOfLeastSquares) {
    // With t = 0 at 500 nm: max(3/4, t) has the integral 25/32 and, about 1/2, the first moment 5/384; the line
    // 25/32 + 12 * 5/384 (t - 1/2) goes from 0.703125 (pulled up to 3/4) to 0.859375.
    const SpectrumTable pulled(PiecewiseLinearSpectrum{{400.0, 500.75, 510.75}, {0.75, 0.75, 10.75}});
    EXPECT_NEAR(at(pulled, 500.0), 0.75f, 1e-6f);
    EXPECT_NEAR(at(pulled, 500.5), 25.0f / 32.0f, 1e-3f);
    // A roof of height 1 over 499.5 to 501.5 nm with its ridge at 500.25 nm:
    const double ridge = 0.25, up = 1.0 / 0.75, down = 1.0 / 1.25;
    const SpectrumTable roof(PiecewiseLinearSpectrum{{499.5, 500.0 + ridge, 501.5}, {0.0, 1.0, 0.0}});
    // 1 less up * (ridge - t) before the ridge, and less down * (t - ridge) after it. Its own line stays below 1.
    const double after = 1.0 - ridge;
    const double mean = 1.0 - 0.5 * (up * ridge * ridge + down * after * after);
    const double first = -up * ridge * ridge * (ridge / 6.0 - 0.25) - down * after * after * (0.25 - after / 6.0);
    EXPECT_NEAR(at(roof, 500.0), mean - 6.0 * first, 1e-6);
    EXPECT_NEAR(at(roof, 500.5), mean, 1e-6);
    EXPECT_NEAR(at(roof, 500.75), mean + 3.0 * first, 1e-6);
}

TEST(SpectrumTable, StaysWithinTheRangeOfTheSpectrum) {
    for (double edge_nm = 500.0; edge_nm < 503.0; edge_nm += 0.0625) {
        const SpectrumTable edge(
            PiecewiseLinearSpectrum{{400.0, edge_nm, edge_nm + 0.01, edge_nm + 0.3, 700.0}, {0.0, 0.0, 1.0, 1.0, 1.0}});
        for (double lambda_nm = 499.0; lambda_nm < 505.0; lambda_nm += 0.03125) {
            EXPECT_GE(at(edge, lambda_nm), 0.0f) << edge_nm << ' ' << lambda_nm;
            EXPECT_LE(at(edge, lambda_nm), 1.0f + 1e-7f) << edge_nm << ' ' << lambda_nm;
        }
    }
}

TEST(SpectrumTable, TakesAScale) {
    const Spectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    const SpectrumTable table(d65), scaled(d65, 2.5e-3);
    for (double lambda_nm = 360.0; lambda_nm <= 830.0; lambda_nm += 7.25) {
        EXPECT_NEAR(at(scaled, lambda_nm), 2.5e-3f * at(table, lambda_nm), 1e-7f);
    }
}

TEST(SpectrumTable, GivesNValuesAtOnce) {
    const SpectrumTable table(tabulated_spectrum("illuminants_5nm", "FL2"));
    const SpectrumTableIndex<4> index({400.25f, 500.5f, 546.0f, 829.75f});
    const SampledSpectrum<4> values = table.at(index);
    EXPECT_EQ(values[0], at(table, 400.25));
    EXPECT_EQ(values[1], at(table, 500.5));
    EXPECT_EQ(values[2], at(table, 546.0));
    EXPECT_EQ(values[3], at(table, 829.75));
}

TEST(SpectrumTable, RefusesWhatIsNotFinite) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(SpectrumTable(ConstantSpectrum{kInfinity}), std::invalid_argument);
    EXPECT_THROW(SpectrumTable(ConstantSpectrum{1.0}, kInfinity), std::invalid_argument);
    EXPECT_THROW(SpectrumTable(PiecewiseLinearSpectrum{}), std::invalid_argument);
    EXPECT_THAT([] { SpectrumTable(ConstantSpectrum{1e39}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("360 nm")));
    EXPECT_NO_THROW(SpectrumTable(SigmoidSpectrum{{0.0, 0.0, kInfinity}}));
}

}  // namespace
}  // namespace emulsion
