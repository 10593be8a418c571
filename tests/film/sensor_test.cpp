#include "film/sensor.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

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
    for (int lambda_nm = kMinWavelength_nm; lambda_nm < kMaxWavelength_nm; ++lambda_nm) {
        const XYZd expected = kLuminousEfficacy * eval(cie_1931_2deg(), lambda_nm);
        EXPECT_EQ(sensor.response(lambda_nm), expected);
    }
    EXPECT_EQ(sensor.response(359.99), XYZd{});
    EXPECT_GT(sensor.response(829.99).x, 0.0);
    EXPECT_EQ(sensor.response(830.0), XYZd{}) << "a jump, and the value above it";
    EXPECT_EQ(sensor.luminance_response(830.0), 0.0);
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) EXPECT_TRUE(std::isnan(sensor.response(bad).y));
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

/// One wavelength, seen by both paths.
std::array<double, 3> seen(const Sensor& sensor, float lambda_nm, float pdf, float radiance) {
    SampledWavelengths<1> wavelengths;
    wavelengths.lambda_nm = {lambda_nm};
    wavelengths.pdf = {pdf};
    const SampledSpectrum<1> values(radiance);
    const auto fast = components(sensor.to_xyz(wavelengths, values));
    const auto reference = components(sensor.to_xyz_reference(wavelengths, values));
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(std::isnan(fast[k]), std::isnan(reference[k])) << lambda_nm << " nm";
        if (std::isfinite(reference[k])) {
            EXPECT_NEAR(fast[k], reference[k], 4e-6 * (reference[0] + reference[1] + reference[2])) << lambda_nm;
        }
    }
    return fast;
}

TEST(Sensor, SeesTheFirstAndTheLastWavelengthOfTheRange) {
    const Sensor sensor;
    for (const float nm : {360.0f, std::nextafter(361.0f, 0.0f), 361.0f, 829.0f, std::nextafter(830.0f, 0.0f)}) {
        EXPECT_GT(seen(sensor, nm, 1.0f, 1.0f)[0], 0.0) << nm;
    }
}

TEST(Sensor, SeesNothingOutsideTheRange) {
    const Sensor sensor;
    for (const float nm : {std::nextafter(360.0f, 0.0f), 359.5f, 0.5f, 0.0f, -0.5f, -1.0f, -400.0f, -1e30f, 830.0f,
                           830.5f, 831.0f, 1190.0f, 1e9f, 4294967296.0f, 4294967796.0f, 1e30f}) {
        EXPECT_EQ(seen(sensor, nm, 0.01f, 5.0f), (std::array<double, 3>{})) << nm;
    }
}

// What can't be right must not look as if it were: the film keeps it out.
TEST(Sensor, PassesOnWhatIsNotFinite) {
    const Sensor sensor;
    for (const float bad : {std::nanf(""), HUGE_VALF, -HUGE_VALF}) {
        EXPECT_TRUE(std::isnan(seen(sensor, bad, 1.0f, 1.0f)[1]));
        EXPECT_FALSE(std::isfinite(seen(sensor, 555.5f, 1.0f, bad)[1]));
    }
    EXPECT_TRUE(std::isnan(seen(sensor, 555.5f, std::nanf(""), 1.0f)[1]));
}

// A wavelength with a pdf of 0 has been given up: the others go on, and N stays.
TEST(Sensor, WavelengthsThatAreGivenUpAddNothing) {
    const Sensor sensor;
    SampledWavelengths<4> wavelengths;
    wavelengths.lambda_nm = {555.25f, 430.0f, 610.0f, 700.0f};
    wavelengths.pdf = {0.01f, 0.0f, -0.0f, 0.0f};
    SampledSpectrum<4> radiance(2.0f);
    SampledWavelengths<1> one;
    one.lambda_nm = {555.25f};
    one.pdf = {0.01f};
    const XYZ alone = sensor.to_xyz(one, SampledSpectrum<1>(2.0f));
    const XYZd alone_exact = sensor.to_xyz_reference(one, SampledSpectrum<1>(2.0f));
    for (const float left_behind : {2.0f, 0.0f, std::nanf(""), HUGE_VALF}) {
        for (int i = 1; i < 4; ++i) radiance[i] = left_behind;
        EXPECT_EQ(sensor.to_xyz(wavelengths, radiance), 0.25f * alone) << left_behind;
        EXPECT_EQ(sensor.to_xyz_reference(wavelengths, radiance), 0.25 * alone_exact) << left_behind;
    }
}

// Numbers that fill no four: against the mean of the single wavelengths. Rounding: 4e-6 for both sides.
TEST(Sensor, TakesAnyNumberOfWavelengths) {
    const Sensor sensor;
    Pcg32 random(4);
    for (std::size_t n = 1; n <= 21; ++n) {
        std::vector<float> lambda_nm, pdf, radiance;
        std::array<double, 3> expected{};
        for (std::size_t i = 0; i < n; ++i) {
            lambda_nm.push_back(400.0f + 300.0f * random.next_float());
            pdf.push_back(0.001f + 0.01f * random.next_float());
            radiance.push_back(random.next_float());
            const auto single = seen(sensor, lambda_nm.back(), pdf.back(), radiance.back());
            for (std::size_t k = 0; k < 3; ++k) expected[k] += single[k] / static_cast<double>(n);
        }
        const auto got = components(sensor.sense(lambda_nm, radiance, pdf).xyz);
        const double size = expected[0] + expected[1] + expected[2];
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 8e-6 * size) << n;
    }
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

TYPED_TEST(SensorWidths, SpansGiveTheSameBits) {
    constexpr int kN = TypeParam::value;
    const Sensor sensor;
    const VisibleWavelengthPdf distribution;
    Pcg32 random(2);
    for (int i = 0; i < 1000; ++i) {
        const auto wavelengths = hero_wavelengths<kN>(distribution, random.next_float());
        SampledSpectrum<kN> radiance;
        for (int k = 0; k < kN; ++k) radiance[k] = random.next_float() - 0.1f;
        const SensorSample expected = sensor.sense(wavelengths, radiance);
        const SensorSample got = sensor.sense(wavelengths.lambda_nm, radiance.value, wavelengths.pdf);
        ASSERT_EQ(got.xyz, expected.xyz);
        ASSERT_EQ(got.luminance, expected.luminance);
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
