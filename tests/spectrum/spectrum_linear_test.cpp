#include "spectrum/spectrum_linear.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "spectrum/spectrum.h"

namespace emulsion {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Extrapolation, OfPiecewiseLinearSpectra) {
    PiecewiseLinearSpectrum table{{400.0, 450.0, 500.0, 600.0}, {2.0, 1.0, 4.0, 3.0}, Extrapolation::hold};
    EXPECT_EQ(eval(table, 399.0), 2.0);
    EXPECT_EQ(eval(table, 1e6), 3.0);
    EXPECT_EQ(limit(table, 400.0, Side::below), 2.0);

    table.extrapolation = Extrapolation::straight;  // falls by 0.02 a nm before, by 0.01 a nm behind
    EXPECT_DOUBLE_EQ(eval(table, 350.0), 3.0);
    EXPECT_DOUBLE_EQ(eval(table, 700.0), 2.0);
    EXPECT_DOUBLE_EQ(eval(table, 1000.0), -1.0);
    EXPECT_EQ(limit(table, 600.0, Side::above), 3.0);

    table.extrapolation = Extrapolation::zero;
    EXPECT_EQ(eval(table, 350.0), 0.0);
    EXPECT_EQ(eval(table, 700.0), 0.0);
}

TEST(Extrapolation, OfDenseSpectra) {
    DenseSpectrum table{400.0, 50.0, {2.0, 1.0, 4.0}, Extrapolation::hold};
    EXPECT_EQ(eval(table, 399.0), 2.0);
    EXPECT_EQ(eval(table, 501.0), 4.0);
    table.extrapolation = Extrapolation::straight;
    EXPECT_DOUBLE_EQ(eval(table, 350.0), 3.0);
    EXPECT_DOUBLE_EQ(eval(table, 600.0), 10.0);
    table.extrapolation = Extrapolation::zero;
    EXPECT_EQ(eval(table, 399.9999), 0.0);
    EXPECT_EQ(eval(table, 500.0001), 0.0);
    EXPECT_EQ(limit(table, 400.0, Side::below), 0.0);
    EXPECT_EQ(limit(table, 400.0, Side::above), 2.0);
    EXPECT_EQ(limit(table, 500.0, Side::below), 4.0);
    EXPECT_EQ(limit(table, 500.0, Side::above), 0.0);
}

TEST(Extrapolation, OfOneSampleIsThatSample) {
    EXPECT_EQ(eval(PiecewiseLinearSpectrum{{500.0}, {2.0}, Extrapolation::hold}, 400.0), 2.0);
    EXPECT_EQ(eval(DenseSpectrum{500.0, 1.0, {2.0}, Extrapolation::hold}, 600.0), 2.0);
    EXPECT_EQ(eval(DenseSpectrum{500.0, 1.0, {2.0}}, 500.0), 2.0);
    EXPECT_EQ(eval(DenseSpectrum{500.0, 1.0, {2.0}}, 500.5), 0.0);
}

TEST(DenseSpectrum, IsThePiecewiseLinearOneOfItsSamples) {
    // A step that no double has, so that knots are rounded.
    DenseSpectrum dense{380.0, 0.1, {}, Extrapolation::zero};
    for (int i = 0; i < 500; ++i) dense.value.push_back(static_cast<double>((i * 37) % 101));
    for (const Extrapolation rule : {Extrapolation::zero, Extrapolation::hold, Extrapolation::straight}) {
        dense.extrapolation = rule;
        const PiecewiseLinearSpectrum piecewise{knots_nm(dense), dense.value, rule};
        for (double lambda_nm = 370.0; lambda_nm < 440.0; lambda_nm += 0.0173) {
            // Cancellation next to 400 nm: 6e-14 nm, times a slope of up to 1000 a nm.
            EXPECT_NEAR(eval(dense, lambda_nm), eval(piecewise, lambda_nm), 1e-9) << lambda_nm;
        }
        for (std::size_t i = 0; i < dense.value.size(); ++i) {
            EXPECT_NEAR(eval(dense, dense.lambda_nm(i)), dense.value[i], 1e-9) << i;
        }
    }
}

TEST(LinearSpectra, RefuseWhatIsOutOfRange) {
    const std::vector<std::pair<Spectrum, std::string>> bad = {
        {PiecewiseLinearSpectrum{{500.0}, {1.0}, Extrapolation::straight}, "1 samples"},
        {DenseSpectrum{400.0, 1.0, {}}, "0 values"},
        {DenseSpectrum{kInfinity, 1.0, {1.0}}, "first_nm = inf"},
        {DenseSpectrum{400.0, 0.0, {1.0}}, "step_nm = 0"},
        {DenseSpectrum{400.0, -1.0, {1.0}}, "step_nm = -1"},
        {DenseSpectrum{400.0, 1e-15, {1.0, 2.0}}, "step_nm = 1e-15"},
        {DenseSpectrum{400.0, 1e308, {1.0, 2.0, 3.0}}, "step_nm = 1e+308"},
        {DenseSpectrum{400.0, 1.0, {1.0, kInfinity}}, "value[1] = inf"},
        {DenseSpectrum{400.0, 1.0, {1.0}, Extrapolation::straight}, "1 samples"},
    };
    for (const auto& [spectrum, message] : bad) {
        EXPECT_THAT([&s = spectrum] { validate(s); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(message), HasSubstr("expected"))));
    }
    EXPECT_NO_THROW(validate(DenseSpectrum{400.0, 1.0, {1.0}}));
}

// Next to 500 nm doubles are 6e-14 nm apart: a ramp of 1e-9 nm is resolved only by offsets from its foot.
TEST(OffsetWavelengths, ResolveWhatSumsWouldRound) {
    const double foot_nm = 500.0, top_nm = 500.0 + 1e-9, width_nm = top_nm - foot_nm;
    const PiecewiseLinearSpectrum ramp{{foot_nm, top_nm}, {0.0, 1.0}};
    const std::vector<double> offset_nm = {0.123 * width_nm, 0.456 * width_nm, 0.789 * width_nm};
    std::vector<double> values(3);
    eval(ramp, OffsetWavelengths{foot_nm, offset_nm}, values);
    EXPECT_THAT(values, ElementsAre(testing::DoubleEq(0.123), testing::DoubleEq(0.456), testing::DoubleEq(0.789)));
}

}  // namespace
}  // namespace emulsion
