// What holds for every alternative of Spectrum.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "spectrum/data_table.h"
#include "spectrum/rgb_uplift.h"
#include "spectrum/spectrum.h"

namespace emulsion {
namespace {

std::vector<Spectrum> one_of_each() {
    const PiecewiseLinearSpectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    const PiecewiseLinearSpectrum irregular{{400.0, 400.01, 555.5, 556.0, 700.0}, {0.0, 3.0, 1.0, 2.0, 0.5}};
    const DenseSpectrum dense{420.0, 2.5, {1.0, 4.0, 2.0, 8.0, 5.0, 7.0}, Extrapolation::straight};
    const LineSpectrum lines{{{435.833, 1.0}}, {{546.074, 0.01, 2.0}, {611.0, 4.0, 3.0}}};
    const SigmoidSpectrum sigmoid{{8.0, -6.0, 0.3}};
    return {ConstantSpectrum{0.7},
            irregular,
            BlackbodySpectrum{2856.0},
            BlackbodySpectrum{6504.0, BlackbodyUnit::radiance},
            sigmoid,
            RgbIlluminantSpectrum{sigmoid, d65, 2.0},
            dense,
            DaylightSpectrum{5000.0},
            lines,
            product_of(d65, sum_of(irregular, lines)),
            sum_of(product_of(irregular, sigmoid), dense, 0.25, 2.0)};
}

class EverySpectrum : public testing::TestWithParam<std::size_t> {
  protected:
    [[nodiscard]] static Spectrum tested() { return one_of_each()[GetParam()]; }
};

TEST(OneOfEach, LeavesNoneOut) {
    std::set<std::size_t> seen;
    for (const Spectrum& spectrum : one_of_each()) seen.insert(spectrum.index());
    EXPECT_EQ(seen.size(), std::variant_size_v<SpectrumVariant>);
}

// Increasing, decreasing, in any order; more than one block; knots and what lies outside too.
TEST_P(EverySpectrum, EvaluatesManyAsOneByOne) {
    const Spectrum spectrum = tested();
    Pcg32 random(7);
    std::vector<double> lambda_nm = knots_nm(spectrum);
    for (int i = 0; i < 300; ++i) lambda_nm.push_back(250.0 + 700.0 * static_cast<double>(random.next_float()));
    for (const int order : {0, 1, 2}) {
        if (order == 1) std::sort(lambda_nm.begin(), lambda_nm.end());
        if (order == 2) std::reverse(lambda_nm.begin(), lambda_nm.end());
        std::vector<double> values(lambda_nm.size(), std::nan(""));
        eval(spectrum, lambda_nm, values);
        for (std::size_t i = 0; i < values.size(); ++i) {
            EXPECT_EQ(values[i], eval(spectrum, lambda_nm[i])) << lambda_nm[i];
        }
    }
}

TEST_P(EverySpectrum, IsWhatItsLimitsAreButForJumps) {
    const Spectrum spectrum = tested();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const std::vector<double> knots = knots_nm(spectrum);
    double largest = 0.0;
    for (const double knot_nm : knots) largest = std::max(largest, std::abs(eval(spectrum, knot_nm)));
    for (const double lambda_nm : {361.3, 450.1, 555.75, 640.1}) {
        ASSERT_FALSE(std::binary_search(knots.begin(), knots.end(), lambda_nm));
        EXPECT_EQ(limit(spectrum, lambda_nm, Side::below), eval(spectrum, lambda_nm));
        EXPECT_EQ(limit(spectrum, lambda_nm, Side::above), eval(spectrum, lambda_nm));
    }
    for (const double knot_nm : knots) {
        const double below = eval(spectrum, std::nextafter(knot_nm, 0.0)),
                     above = eval(spectrum, std::nextafter(knot_nm, kInfinity));
        EXPECT_NEAR(limit(spectrum, knot_nm, Side::below), below, 1e-9 * largest) << knot_nm;
        EXPECT_NEAR(limit(spectrum, knot_nm, Side::above), above, 1e-9 * largest) << knot_nm;
    }
}

TEST_P(EverySpectrum, HasIncreasingKnotsAndLines) {
    const Spectrum spectrum = tested();
    const std::vector<double> knots = knots_nm(spectrum);
    EXPECT_EQ(std::adjacent_find(knots.begin(), knots.end(), std::greater_equal<>()), knots.end());
    const std::vector<Line> lines = delta_lines(spectrum);
    const auto not_below = [](const Line& a, const Line& b) { return a.lambda_nm >= b.lambda_nm; };
    EXPECT_EQ(std::adjacent_find(lines.begin(), lines.end(), not_below), lines.end());
}

TEST_P(EverySpectrum, IsAValue) {
    const Spectrum spectrum = tested();
    EXPECT_NO_THROW(validate(spectrum));
    EXPECT_TRUE(spectrum == tested());
    EXPECT_FALSE(spectrum == scaled(spectrum, 2.0));
    EXPECT_DOUBLE_EQ(eval(scaled(spectrum, 2.0), 500.0), 2.0 * eval(spectrum, 500.0));
}

INSTANTIATE_TEST_SUITE_P(Spectra, EverySpectrum, testing::Range(std::size_t{0}, one_of_each().size()));

TEST(EvalOfMany, NeedsRoomForEveryValue) {
    const std::vector<double> lambda_nm = {400.0, 500.0};
    std::vector<double> values(3);
    EXPECT_THROW(eval(Spectrum(ConstantSpectrum{1.0}), lambda_nm, values), std::invalid_argument);
    EXPECT_NO_THROW(eval(Spectrum(ConstantSpectrum{1.0}), std::span<const double>(), {}));
}

}  // namespace
}  // namespace emulsion
