#include "spectrum/spectrum_compound.h"

#include <cmath>
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
using testing::IsEmpty;
using testing::ThrowsMessage;

const PiecewiseLinearSpectrum kRamp{{400.0, 700.0}, {1.0, 4.0}};
const DenseSpectrum kHat{500.0, 50.0, {0.0, 2.0, 0.0}};

TEST(LineSpectrum, GaussianHasItsWidthAndPeak) {
    const double sigma_nm = 2.0 / std::sqrt(8.0 * std::log(2.0));
    const LineSpectrum line{{}, {{550.0, 2.0, 3.0}}};
    const double peak = 3.0 / (sigma_nm * std::sqrt(2.0 * std::acos(-1.0)));
    EXPECT_NEAR(eval(line, 550.0), peak, 1e-15);
    EXPECT_NEAR(eval(line, 549.0), 0.5 * peak, 1e-14) << "half of it at half the full width";
    EXPECT_NEAR(eval(line, 551.0), 0.5 * peak, 1e-14);
    EXPECT_NEAR(eval(line, 550.0 + sigma_nm), peak * std::exp(-0.5), 1e-13) << "550 + sigma is rounded";
    EXPECT_EQ(eval(line, 400.0), 0.0);
}

TEST(LineSpectrum, LinesWithoutWidthHaveNoValue) {
    const LineSpectrum mercury{{{435.833, 2.0}, {404.656, 1.0}}, {}};
    EXPECT_EQ(eval(mercury, 435.833), 0.0);
    EXPECT_THAT(knots_nm(mercury), IsEmpty());
    EXPECT_THAT(delta_lines(mercury), ElementsAre(Line{404.656, 1.0}, Line{435.833, 2.0}));
    EXPECT_THAT(delta_lines(kRamp), IsEmpty());
}

TEST(Product, MultipliesValuesAndLimits) {
    const Spectrum product = product_of(kRamp, kHat, 10.0);
    EXPECT_DOUBLE_EQ(eval(product, 525.0), 10.0 * 2.25 * 1.0);
    EXPECT_EQ(eval(product, 450.0), 0.0);
    EXPECT_THAT(knots_nm(product), ElementsAre(400.0, 500.0, 550.0, 600.0, 700.0));
    EXPECT_EQ(polynomial_degree(product), 2);
    EXPECT_EQ(limit(scaled(kRamp, 3.0), 700.0, Side::below), 12.0);
    EXPECT_EQ(limit(scaled(kRamp, 3.0), 700.0, Side::above), 0.0);
    EXPECT_EQ(eval(ProductSpectrum{{}, 3.0}, 500.0), 3.0);
}

TEST(Sum, AddsValuesAndLimits) {
    const Spectrum sum = sum_of(kRamp, kHat, 2.0, -1.0);
    EXPECT_DOUBLE_EQ(eval(sum, 525.0), 2.0 * 2.25 - 1.0);
    EXPECT_EQ(limit(sum, 400.0, Side::above), 2.0);
    EXPECT_EQ(limit(sum, 400.0, Side::below), 0.0);
    EXPECT_EQ(polynomial_degree(sum), 1);
    EXPECT_EQ(eval(SumSpectrum{}, 500.0), 0.0);
}

TEST(Compounds, NestAndAreValues) {
    const Spectrum lamp = sum_of(BlackbodySpectrum{3000.0}, LineSpectrum{{{546.074, 7.0}}, {}}, 0.5);
    const Spectrum seen = product_of(lamp, product_of(kRamp, ConstantSpectrum{0.5}));
    EXPECT_DOUBLE_EQ(eval(seen, 600.0), 0.5 * eval(BlackbodySpectrum{3000.0}, 600.0) * 3.0 * 0.5);
    EXPECT_EQ(polynomial_degree(seen), std::nullopt);
    Spectrum copy = seen;
    EXPECT_TRUE(copy == seen);
    std::get<ProductSpectrum>(copy).factor.pop_back();
    EXPECT_FALSE(copy == seen);
    EXPECT_EQ(std::get<ProductSpectrum>(seen).factor.size(), 2u);
}

TEST(DeltaLines, GoThroughSumsAndProducts) {
    const LineSpectrum two{{{500.0, 2.0}, {450.0, 1.0}}, {}}, other{{{500.0, 10.0}, {800.0, 1.0}}, {}};
    EXPECT_THAT(delta_lines(sum_of(two, other, 1.0, 0.5)),
                ElementsAre(Line{450.0, 1.0}, Line{500.0, 7.0}, Line{800.0, 0.5}));
    // The ramp is 1.5 at 450, 2 at 500 nm; and 0 at 800 nm, outside it.
    EXPECT_THAT(delta_lines(product_of(kRamp, two, 4.0)), ElementsAre(Line{450.0, 6.0}, Line{500.0, 16.0}));
    EXPECT_THAT(delta_lines(product_of(other, kRamp)), ElementsAre(Line{500.0, 20.0}, Line{800.0, 0.0}));
    // (ramp + two) (ramp + line) has each line times the other factor's continuum.
    const Spectrum a = sum_of(kRamp, two), b = sum_of(kRamp, LineSpectrum{{{600.0, 1.0}}, {}});
    EXPECT_THAT(delta_lines(product_of(a, b)), ElementsAre(Line{450.0, 1.5}, Line{500.0, 4.0}, Line{600.0, 3.0}));
}

TEST(Compounds, RefuseWhatIsOutOfRange) {
    const LineSpectrum line{{{500.0, 1.0}}, {}};
    const double nan = std::nan("");
    const std::vector<std::pair<Spectrum, std::string>> bad = {
        {LineSpectrum{{{-1.0, 1.0}}, {}}, "line[0].lambda_nm = -1"},
        {LineSpectrum{{{500.0, 1.0}, {400.0, nan}}, {}}, "line[1].power = nan"},
        {LineSpectrum{{{500.0, 1.0}, {400.0, 1.0}, {500.0, 1.0}}, {}}, "two lines at lambda_nm = 500"},
        {LineSpectrum{{}, {{0.0, 1.0, 1.0}}}, "gaussian[0].mean_nm = 0"},
        {LineSpectrum{{}, {{500.0, 0.9e-6, 1.0}}}, "gaussian[0].fwhm_nm = 9e-07"},
        {LineSpectrum{{}, {{500.0, nan, 1.0}}}, "gaussian[0].fwhm_nm = nan"},
        {LineSpectrum{{}, {{500.0, 1.0, nan}}}, "gaussian[0].power = nan"},
        {product_of(line, sum_of(kRamp, line)), "lambda_nm = 500"},
        {ProductSpectrum{{kRamp}, nan}, "scale = nan"},
        {scaled(BlackbodySpectrum{-1.0}, 1.0), "temperature_K = -1"},
        {SumSpectrum{{kRamp}, {}}, "1 terms and 0 weights"},
        {sum_of(kRamp, line, 1.0, nan), "weight[1] = nan"},
        {sum_of(kRamp, PiecewiseLinearSpectrum{}), "0 wavelengths"},
    };
    for (const auto& [spectrum, message] : bad) {
        EXPECT_THAT([&s = spectrum] { validate(s); },
                    ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr(message), HasSubstr("expected"))));
    }
    EXPECT_NO_THROW(validate(product_of(line, LineSpectrum{{{501.0, 1.0}}, {}})));
    EXPECT_NO_THROW(validate(product_of(line, LineSpectrum{{}, {{500.0, 1e-6, 1.0}}})));
}

}  // namespace
}  // namespace emulsion
