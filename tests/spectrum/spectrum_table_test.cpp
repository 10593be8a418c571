#include "spectrum/spectrum_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/data_table.h"
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
