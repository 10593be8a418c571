#include "film/sensor.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "core/random.h"
#include "spectrum/observer.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

struct TestSpectrum {
    std::string name;
    double (*radiance)(double lambda_nm);  // W m^-2 sr^-1 nm^-1
};

const std::array<TestSpectrum, 4> kSpectra = {{
    {"constant", [](double) { return 1.0; }},
    {"rising", [](double lambda_nm) { return (lambda_nm - 350.0) / 100.0; }},
    {"narrow band", [](double lambda_nm) { return std::exp(-std::pow((lambda_nm - 610.0) / 12.0, 2.0)); }},
    {"blue step", [](double lambda_nm) { return lambda_nm < 480.0 ? 2.0 : 0.1; }},
}};

/// 683 integral of L xyzbar, the observer's straight lines cut into pieces of 1/64 nm.
XYZd integral(const TestSpectrum& spectrum) {
    constexpr int kPieces = 64;
    XYZd sum;
    for (int i = 0; i < (kMaxWavelength_nm - kMinWavelength_nm) * kPieces; ++i) {
        const double lambda_nm = kMinWavelength_nm + (i + 0.5) / kPieces;
        sum = sum + (spectrum.radiance(lambda_nm) / kPieces) * eval(cie_1931_2deg(), lambda_nm);
    }
    return kLuminousEfficacy * sum;
}

template <int N>
SampledSpectrum<N> sample(const TestSpectrum& spectrum, const SampledWavelengths<N>& wavelengths) {
    SampledSpectrum<N> values;
    for (std::size_t i = 0; i < N; ++i) {
        values.value[i] = static_cast<float>(spectrum.radiance(static_cast<double>(wavelengths.lambda_nm[i])));
    }
    return values;
}

template <class T>
std::array<double, 3> components(const BasicXYZ<T>& xyz) {
    return {static_cast<double>(xyz.x), static_cast<double>(xyz.y), static_cast<double>(xyz.z)};
}

TEST(Sensor, RespondsAsTheObserverTimesTheEfficacy) {
    const Sensor sensor;
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        const XYZd expected = kLuminousEfficacy * eval(cie_1931_2deg(), lambda_nm);
        EXPECT_EQ(sensor.response(lambda_nm), expected);
    }
    EXPECT_EQ(sensor.response(359.99), XYZd{});
    EXPECT_EQ(sensor.response(830.01), XYZd{});
    EXPECT_NEAR(sensor.response(555.0).y, 683.0, 1e-3);
    EXPECT_NEAR(sensor.response(500.5).y, 0.5 * (sensor.response(500).y + sensor.response(501).y), 1e-12);
}

// The sum of ybar at 1 nm is 106.856917 (CIE 15:2004), so that a constant radiance of 1 has Y = 683 * 106.856917 but
// for half the two ends.
TEST(Sensor, ResponseIntegratesToTheObserver) { EXPECT_NEAR(integral(kSpectra[0]).y, 683.0 * 106.856917, 1.0); }

TEST(Sensor, ImagingRatioScales) {
    const Sensor plain, bright({.exposure_time_s = 0.5, .iso = 500.0});
    EXPECT_EQ(bright.imaging_ratio(), 2.5);
    SampledWavelengths<1> wavelengths;
    wavelengths.lambda_nm = {600.25f};
    wavelengths.pdf = {0.5f};
    const SampledSpectrum<1> radiance(3.0f);
    EXPECT_NEAR(static_cast<double>(bright.to_xyz(wavelengths, radiance).x),
                2.5 * static_cast<double>(plain.to_xyz(wavelengths, radiance).x), 1e-2);
    EXPECT_DOUBLE_EQ(plain.to_xyz_reference(wavelengths, radiance).x, 6.0 * plain.response(600.25).x);
}

TEST(Sensor, TakesTheEndsOfTheRange) {
    const Sensor sensor;
    SampledWavelengths<2> wavelengths;
    wavelengths.lambda_nm = {360.0f, 830.0f};
    wavelengths.pdf = {1.0f, 1.0f};
    const SampledSpectrum<2> radiance(1.0f);
    const double expected = 0.5 * (sensor.response(360.0).x + sensor.response(830.0).x);
    EXPECT_GT(expected, 0.0);
    EXPECT_NEAR(static_cast<double>(sensor.to_xyz(wavelengths, radiance).x), expected, 1e-6 * expected);
}

template <class Width>
class SensorWidths : public testing::Test {};
using Widths =
    testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>, std::integral_constant<int, 4>,
                   std::integral_constant<int, 8>, std::integral_constant<int, 16>, std::integral_constant<int, 32>>;
TYPED_TEST_SUITE(SensorWidths, Widths);

TYPED_TEST(SensorWidths, FastPathAgreesWithTheReference) {
    constexpr int kN = TypeParam::value;
    const Sensor sensor;
    const VisibleWavelengthPdf distribution;
    Pcg32 random(1);
    for (int i = 0; i < 20000; ++i) {
        const auto wavelengths = hero_wavelengths<kN>(distribution, random.next_float());
        SampledSpectrum<kN> radiance;
        for (int k = 0; k < kN; ++k) radiance[k] = 10.0f * random.next_float();
        const auto fast = components(sensor.to_xyz(wavelengths, radiance));
        const auto reference = components(sensor.to_xyz_reference(wavelengths, radiance));
        const double size = reference[0] + reference[1] + reference[2];
        for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(fast[k], reference[k], 4e-6 * size);
    }
}

// 10,000 seeds per spectrum; each estimate's mean against the integral. 6 widths, 4 spectra and 3 components are 72
// tests; together they raise a false alarm in 1 of 1,000 sets of seeds: each at 1.4e-5, |z| < 4.35. Before the test
// says anything, it makes sure that an error of 1% in the widest spectrum would not pass.
TYPED_TEST(SensorWidths, SampleToXyzIsUnbiasedOverTenThousandSeeds) {
    constexpr int kN = TypeParam::value;
    constexpr int kSeeds = 10000;
    const Sensor sensor;
    const VisibleWavelengthPdf distribution;
    for (const TestSpectrum& spectrum : kSpectra) {
        std::array<double, 3> sum{}, squares{};
        for (int seed = 0; seed < kSeeds; ++seed) {
            Pcg32 random(static_cast<std::uint64_t>(seed));
            const auto wavelengths = hero_wavelengths<kN>(distribution, random.next_float());
            const auto xyz = components(sensor.to_xyz(wavelengths, sample(spectrum, wavelengths)));
            for (std::size_t k = 0; k < 3; ++k) {
                sum[k] += xyz[k];
                squares[k] += xyz[k] * xyz[k];
            }
        }
        const auto expected = components(integral(spectrum));
        for (std::size_t k = 0; k < 3; ++k) {
            const double mean = sum[k] / kSeeds;
            const double standard_error = std::sqrt((squares[k] / kSeeds - mean * mean) / kSeeds);
            // Rounding of the fast path, and of u to 2^-24, is part of what a mean of stratified samples shows.
            const double rounding = 4e-6 * (expected[0] + expected[1] + expected[2]);
            EXPECT_LT(std::abs(mean - expected[k]), 4.35 * standard_error + rounding)
                << spectrum.name << ", component " << k << ", N = " << kN;
            if (spectrum.name == "constant" && k == 1) {
                EXPECT_LT(4.35 * standard_error + rounding, 0.06 * expected[k]);
            }
        }
    }
}

}  // namespace
}  // namespace emulsion
