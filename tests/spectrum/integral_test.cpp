#include "spectrum/integral.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/units.h"
#include "spectrum/data_table.h"
#include "spectrum/integral_panels.h"

namespace emulsion {
namespace {

constexpr double kPi = 3.14159265358979323846;

void expect_relative(double value, double expected, double tolerance) {
    EXPECT_NEAR(value / expected, 1.0, tolerance) << value << " for " << expected;
}

// Monomials over [0, 1]: 1 / (n + 1).
TEST(Quadrature, RulesAreExactToTheirDegrees) {
    const auto sum = [](const auto& points, const auto& weights, int power) {
        double total = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) total += weights[i] * std::pow(points[i], power);
        return total;
    };
    for (int degree = 0; degree <= kMaxGaussDegree; ++degree) {
        const QuadratureRule& rule = gauss_rule(degree);
        EXPECT_EQ(rule.point.size(), static_cast<std::size_t>(degree / 2 + 1));
        const int exact_to = 2 * (degree / 2) + 1;
        for (int n = 0; n <= exact_to; ++n) EXPECT_NEAR(sum(rule.point, rule.weight, n), 1.0 / (n + 1), 4e-16) << n;
        EXPECT_GT(std::abs(sum(rule.point, rule.weight, exact_to + 1) - 1.0 / (exact_to + 2)), 1e-11);
    }
    const KronrodRule& rule = kronrod_rule();
    for (int n = 0; n <= 11; ++n) EXPECT_NEAR(sum(rule.point, rule.weight, n), 1.0 / (n + 1), 4e-16) << n;
    for (int n = 0; n <= 5; ++n) EXPECT_NEAR(sum(rule.point, rule.gauss_weight, n), 1.0 / (n + 1), 4e-16) << n;
    EXPECT_GT(std::abs(sum(rule.point, rule.weight, 12) - 1.0 / 13.0), 1e-9);
}

TEST(Integral, OfTablesIsTheirTrapezoids) {
    const PiecewiseLinearSpectrum d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    double expected = 0.0;
    for (std::size_t i = 0; i + 1 < d65.value.size(); ++i) expected += 2.5 * (d65.value[i] + d65.value[i + 1]);
    expect_relative(integral(d65, 300.0, 830.0), expected, 1e-12);
    expect_relative(integral(d65, 1.0, 1e5), expected, 1e-12);
    // A piece with ends that are no knots: 402.5 to 404 nm of the line from 400 to 405.
    const double at_402_5 = eval(d65, 402.5), at_404 = eval(d65, 404.0);
    expect_relative(integral(d65, 402.5, 404.0), 0.75 * (at_402_5 + at_404), 1e-12);
    EXPECT_EQ(integral(d65, 500.0, 500.0), 0.0);
    EXPECT_EQ(integral(d65, 900.0, 1000.0), 0.0);
}

TEST(Integral, CutsAtJumps) {
    // 1 on [500.25, 501.5]; times a ramp that begins at 500.75 and is 1 there.
    const Spectrum pulse = PiecewiseLinearSpectrum{{500.25, 501.5}, {1.0, 1.0}};
    const Spectrum ramp = DenseSpectrum{500.75, 1.0, {1.0, 2.0}};
    expect_relative(integral(pulse, 360.0, 830.0), 1.25, 1e-13);
    expect_relative(integral_of_product({pulse, ramp}, 360.0, 830.0), 0.75 + 0.5 * 0.75 * 0.75, 1e-13);
    expect_relative(integral_of_product({ramp, pulse, pulse}, 500.0, 501.0), 0.25 + 0.5 * 0.25 * 0.25, 1e-13);
}

// (lambda - 400)^n from 380 to 500 nm, by straight lines that go on below 0: odd powers change their sign.
TEST(Integral, OfProductsOfLinesIsExact) {
    const Spectrum line = PiecewiseLinearSpectrum{{420.0, 470.0}, {0.02, 0.07}, Extrapolation::straight};
    const auto expected = [](int n) { return (std::pow(0.1, n + 1) - std::pow(-0.02, n + 1)) * 1000.0 / (n + 1); };
    expect_relative(integral(line, 380.0, 500.0), expected(1), 1e-13);
    expect_relative(integral_of_product({line, line}, 380.0, 500.0), expected(2), 1e-13);
    expect_relative(integral_of_product({line, line, line}, 380.0, 500.0), expected(3), 1e-13);
    expect_relative(integral_of_product({line, line, line, line}, 380.0, 500.0), expected(4), 1e-13);
    const Spectrum fourth = product_of(product_of(line, line), product_of(line, line));
    expect_relative(integral_of_product({fourth, fourth, fourth}, 380.0, 500.0), expected(12), 1e-12);
    // Degree 16 is more than the rules have; it is halved until it is right.
    expect_relative(integral_of_product({fourth, fourth, fourth, fourth}, 380.0, 500.0), expected(16), 1e-12);
}

TEST(Integral, OfNarrowTrianglesIsTheirArea) {
    const Spectrum line = PiecewiseLinearSpectrum{{300.0, 900.0}, {1.0, 7.0}};
    for (const double half_nm : {30.0, 1.0, 1e-3, 1e-6, 1e-9, 1e-11}) {
        const double first_nm = 555.4 - half_nm, last_nm = 555.4 + half_nm;
        const Spectrum triangle = PiecewiseLinearSpectrum{{first_nm, 555.4, last_nm}, {0.0, 1.0, 0.0}};
        const double area = 0.5 * (last_nm - first_nm);
        expect_relative(integral(triangle, 360.0, 830.0), area, 1e-12);
        const double mean_nm = (first_nm + 555.4 + last_nm) / 3.0;
        expect_relative(integral_of_product({triangle, line}, 360.0, 830.0), area * (1.0 + (mean_nm - 300.0) / 100.0),
                        1e-12);
    }
}

// Integral of x^3 / (e^x - 1) from x to infinity, by its series.
double planck_tail(double x) {
    double sum = 0.0;
    for (int n = 1; n < 400; ++n) {
        const double m = n;
        sum +=
            std::exp(-m * x) * (x * x * x / m + 3.0 * x * x / (m * m) + 6.0 * x / (m * m * m) + 6.0 / (m * m * m * m));
    }
    return sum;
}

TEST(Integral, OfBlackbodiesIsTheSeries) {
    for (const double temperature_K : {10.0, 100.0, 300.0, 2042.0, 6504.0, 100000.0}) {
        const auto x = [=](double lambda_nm) { return 1e9 * kSecondRadiation_mK / (lambda_nm * temperature_K); };
        // Radiance between two wavelengths: 2 (k T)^4 / (h^3 c^2) integral of x^3 / (e^x - 1).
        const double kt = kBoltzmann * temperature_K;
        const double unit = 2.0 * std::pow(kt / kPlanck, 3.0) * kt / (kSpeedOfLight * kSpeedOfLight);
        const BlackbodySpectrum body{temperature_K, BlackbodyUnit::radiance};
        if (x(360.0) < 700.0) {
            const double expected = unit * (planck_tail(x(830.0)) - planck_tail(x(360.0)));
            expect_relative(integral(body, 360.0, 830.0), expected, 1e-9);
        }
        // The whole of it, up to 1/10 of a thousandth: 1 to 40000 times the shortest wavelength of note.
        const double from_nm = 1e9 * kSecondRadiation_mK / (600.0 * temperature_K), to_nm = 15000.0 * from_nm;
        expect_relative(integral(body, from_nm, to_nm), unit * planck_tail(x(to_nm)), 1e-9);
    }
}

// With c0 = 0 the antiderivative is known: x / 2 + sqrt(1 + x^2) / 2.
TEST(Integral, OfSigmoidEdgesHoweverSteep) {
    for (const double slope : {0.5, 10.0, 1e3, 1e5, 1e7, 1e9, -1e6}) {
        for (const double edge : {0.31234, 0.5, 0.9}) {
            const SigmoidSpectrum sigmoid{{0.0, slope, -slope * edge}};
            const auto antiderivative = [=](double t) {
                const double x = slope * (t - edge);
                return 0.5 * (x + std::hypot(1.0, x));
            };
            // Written so that nothing cancels: the side where the argument is negative has little.
            const double expected = 470.0 / slope * (antiderivative(1.0) - antiderivative(0.0));
            expect_relative(integral(sigmoid, 360.0, 830.0), expected, 1e-9);
        }
    }
}

// sigmoid(-k (t - 1/2)^2): a bump of height 1/2 and of a width of 470 nm / sqrt(k). With v = sqrt(k) (t - 1/2), its
// integral is 470 / sqrt(k) integral from 0 to infinity of 1 - v^2 / sqrt(1 + v^4) = B(3/4, 3/4) / 2.
TEST(Integral, OfSigmoidBumpsHoweverNarrow) {
    const double half_beta = 0.5 * std::pow(std::tgamma(0.75), 2.0) / std::tgamma(1.5);
    for (const double k : {1e7, 1e8, 1e10, 1e12}) {
        // The sigmoid's argument is the difference of numbers of size k, known to k 2^-53 only.
        const double tolerance = 1e-9 + 2.0 * k * std::numeric_limits<double>::epsilon();
        for (const double middle : {0.5, 0.61803}) {
            const SigmoidSpectrum bump{{-k, 2.0 * k * middle, -k * middle * middle}};
            // What lies outside 360-830 nm is below (3 sqrt(k) / 4)^-3 of it.
            expect_relative(integral(bump, 360.0, 830.0), 470.0 / std::sqrt(k) * half_beta, tolerance);
        }
    }
}

TEST(Integral, OfGaussiansHoweverNarrow) {
    const Spectrum line = PiecewiseLinearSpectrum{{300.0, 900.0}, {1.0, 7.0}};
    for (const double fwhm_nm : {1e-6, 1e-5, 1e-3, 0.01, 0.1, 1.0, 10.0, 30.0}) {
        for (const double mean_nm : {500.0, 546.0743, 611.123456789}) {
            const Spectrum gaussian = LineSpectrum{{}, {{mean_nm, fwhm_nm, 3.0}}};
            expect_relative(integral(gaussian, 360.0, 830.0), 3.0, 1e-9);
            expect_relative(integral(gaussian, 360.0, mean_nm), 1.5, 1e-9);
            expect_relative(integral_of_product({gaussian, line}, 300.0, 900.0),
                            3.0 * (1.0 + (mean_nm - 300.0) / 100.0), 1e-9);
            const double sigma_nm = fwhm_nm / std::sqrt(8.0 * std::log(2.0));
            const double end_nm = mean_nm + 0.7 * sigma_nm, sigmas = (end_nm - mean_nm) / sigma_nm;
            expect_relative(integral(gaussian, mean_nm, end_nm), 1.5 * std::erf(sigmas / std::sqrt(2.0)), 1e-9);
        }
    }
    // exp(-lambda^2/2s^2)^2 is a Gaussian of 1/sqrt(2) the width.
    const Spectrum one = LineSpectrum{{}, {{550.0, 0.02, 1.0}}};
    const double sigma_nm = 0.02 / std::sqrt(8.0 * std::log(2.0));
    expect_relative(integral_of_product({one, one}, 360.0, 830.0), 1.0 / (2.0 * sigma_nm * std::sqrt(kPi)), 1e-9);
}

TEST(Integral, CountsLinesWithoutWidth) {
    const Spectrum lamp = sum_of(ConstantSpectrum{0.1}, LineSpectrum{{{400.0, 1.0}, {500.0, 2.0}, {600.0, 4.0}}, {}});
    const Spectrum ramp = PiecewiseLinearSpectrum{{400.0, 600.0}, {0.0, 1.0}};
    expect_relative(integral(lamp, 450.0, 550.0), 10.0 + 2.0, 1e-13);
    expect_relative(integral(lamp, 400.0, 600.0), 20.0 + 7.0, 1e-13);
    EXPECT_EQ(integral(LineSpectrum{{{500.0, 2.0}}, {}}, 500.0, 500.0), 2.0);
    expect_relative(integral_of_product({lamp, ramp}, 360.0, 830.0), 10.0 + 2.0 * 0.5 + 4.0, 1e-13);
    expect_relative(integral_of_product({ramp, lamp, ramp}, 360.0, 830.0), 0.1 * 200.0 / 3.0 + 0.5 + 4.0, 1e-13);
    EXPECT_THROW((void)integral_of_product({lamp, lamp}, 360.0, 830.0), std::invalid_argument);

    const Spectrum line = LineSpectrum{{{555.0, 2.0}}, {}};
    EXPECT_EQ(integral_with_observer({line}, cie_1931_2deg()), 2.0 * eval(cie_1931_2deg(), 555.0));
}

TEST(Integral, WithAnObserverIsThatOfEachFunction) {
    const Observer& observer = cie_1931_2deg();
    DenseSpectrum x{360.0, 1.0, {}}, z{360.0, 1.0, {}};
    for (const XYZd& value : observer.value) {
        x.value.push_back(value.x);
        z.value.push_back(value.z);
    }
    const Spectrum xbar = x, zbar = z, d65 = tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    const Spectrum sigmoid = SigmoidSpectrum{{8.0, -6.0, 0.3}};
    const XYZd together = integral_with_observer({d65, sigmoid}, observer);
    expect_relative(together.x, integral_of_product({d65, sigmoid, xbar}, 360.0, 830.0), 1e-12);
    expect_relative(together.z, integral_of_product({d65, sigmoid, zbar}, 360.0, 830.0), 1e-12);
}

TEST(Integral, RefusesBadRanges) {
    const Spectrum one = ConstantSpectrum{1.0};
    EXPECT_THROW((void)integral(one, 500.0, 400.0), std::invalid_argument);
    EXPECT_THROW((void)integral(one, std::nan(""), 400.0), std::invalid_argument);
    EXPECT_THROW((void)integral(one, 400.0, std::numeric_limits<double>::infinity()), std::invalid_argument);
    EXPECT_THROW((void)integral(ConstantSpectrum{std::nan("")}, 400.0, 500.0), std::invalid_argument);
}

}  // namespace
}  // namespace emulsion
