// What must hold for sensors of every kind: observers, cameras, white balances, exposures.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/random.h"
#include "film/sensor.h"
#include "sensor_fixture.h"
#include "spectrum/wavelength_sampling.h"

namespace emulsion {
namespace {

using testing::components;
using testing::every_sensor;
using testing::expected_xyz;
using testing::NamedSensor;
using testing::seen_by;

std::array<double, 4> numbers(const SensorSample& sample) {
    return {static_cast<double>(sample.xyz.x), static_cast<double>(sample.xyz.y), static_cast<double>(sample.xyz.z),
            static_cast<double>(sample.luminance)};
}

template <int N>
SampledSpectrum<N> sample(const Spectrum& spectrum, const SampledWavelengths<N>& wavelengths) {
    SampledSpectrum<N> values;
    for (std::size_t i = 0; i < N; ++i) {
        values.value[i] = static_cast<float>(eval(spectrum, static_cast<double>(wavelengths.lambda_nm[i])));
    }
    return values;
}

const std::vector<Spectrum>& lights() {
    static const std::vector<Spectrum> all = {
        ConstantSpectrum{1.0}, BlackbodySpectrum{2856.0},
        PiecewiseLinearSpectrum{{400.0, 440.0, 480.0, 550.0}, {0.0, 1.0, 0.05, 0.3}}};
    return all;
}

// The table is the exact integrals' own function, jumps at its ends included. Of the blackbody, Gauss's rule is good to
// 1e-12 a nanometre.
TEST(EverySensor, ItsTableIntegratesToTheExactIntegral) {
    for (const auto& [name, options] : every_sensor()) {
        const Sensor sensor(options);
        for (const Spectrum& light : lights()) {
            const auto got = components(seen_by(sensor, light)), expected = components(expected_xyz(options, light));
            const double size = std::abs(expected[0]) + std::abs(expected[1]) + std::abs(expected[2]);
            for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(got[k], expected[k], 1e-11 * size) << name;
        }
    }
}

// 4e-6 of the sum of all terms taken positive, as the header says.
TEST(EverySensor, FastPathAgreesWithTheReference) {
    const VisibleWavelengthPdf distribution;
    for (const NamedSensor& tested : every_sensor()) {
        const Sensor sensor(tested.options);
        for_each_wavelength_count([&]<int N>() {
            Pcg32 random(1);
            for (int i = 0; i < 3000; ++i) {
                const auto wavelengths = hero_wavelengths<N>(distribution, random.next_float());
                SampledSpectrum<N> radiance;
                for (int k = 0; k < N; ++k) radiance[k] = 10.0f * random.next_float() - (i % 2 == 0 ? 0.0f : 5.0f);
                const auto fast = numbers(sensor.sense(wavelengths, radiance));
                const auto exact = components(sensor.to_xyz_reference(wavelengths, radiance));
                double luminance = 0.0, luminance_size = 0.0, size = 0.0;
                for (std::size_t k = 0; k < N; ++k) {
                    const double nm = static_cast<double>(wavelengths.lambda_nm[k]);
                    const double scaled =
                        static_cast<double>(radiance.value[k]) / static_cast<double>(wavelengths.pdf[k]) / N;
                    const auto response = components(sensor.response(nm));
                    luminance += scaled * sensor.luminance_response(nm);
                    luminance_size += std::abs(scaled) * sensor.luminance_response(nm);
                    for (const double r : response) size += std::abs(scaled * r);
                }
                for (std::size_t k = 0; k < 3; ++k)
                    ASSERT_NEAR(fast[k], exact[k], 4e-6 * size) << tested.name << ", N " << N;
                ASSERT_NEAR(fast[3], luminance, 4e-6 * luminance_size) << tested.name << ", N " << N;
            }
        });
    }
}

// Twice the time or twice the ISO is twice the number, to the bit, and every power of two.
TEST(EverySensor, ExposureScalesExactly) {
    const VisibleWavelengthPdf distribution;
    for (auto [name, options] : every_sensor()) {
        const Sensor plain(options);
        options.exposure_time_s *= 0.125;
        options.iso *= 64.0;
        const Sensor bright(options);
        EXPECT_EQ(bright.imaging_ratio(), 8.0 * plain.imaging_ratio());
        Pcg32 random(2);
        for (int i = 0; i < 100; ++i) {
            const auto wavelengths = hero_wavelengths<4>(distribution, random.next_float());
            const SampledSpectrum<4> radiance(random.next_float());
            const auto one = numbers(plain.sense(wavelengths, radiance));
            const auto eight = numbers(bright.sense(wavelengths, radiance));
            for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(eight[k], 8.0 * one[k]) << name;
        }
    }
}

// Luminance is that of the eye: not balanced, through no camera.
TEST(EverySensor, LuminanceIsTheObservers) {
    for (const auto& [name, options] : every_sensor()) {
        const Sensor sensor(options);
        const Observer& eye = observer(options.observer);
        for (const double nm : {380.25, 432.0, 555.0, 700.5, 829.75}) {
            const double expected = kLuminousEfficacy * imaging_ratio(options) * eval(eye, nm).y;
            EXPECT_NEAR(sensor.luminance_response(nm), expected, 1e-14 * std::abs(expected)) << name << " at " << nm;
        }
    }
}

// 2,000 seeds; each estimate's mean against the exact integral. 10 sensors, 3 lights and 3 components are 90 tests;
// together they raise a false alarm in 1 of 1,000 sets of seeds: each at 1.1e-5, |z| < 4.40. An error of 3% in the
// luminance of the constant light would not pass.
TEST(EverySensor, SampleToXyzIsUnbiased) {
    constexpr int kSeeds = 2000;
    const VisibleWavelengthPdf distribution;
    ASSERT_EQ(every_sensor().size(), 10u);
    for (const auto& [name, options] : every_sensor()) {
        const Sensor sensor(options);
        for (const Spectrum& light : lights()) {
            std::array<double, 3> sum{}, squares{};
            for (int seed = 0; seed < kSeeds; ++seed) {
                Pcg32 random(static_cast<std::uint64_t>(seed));
                const auto wavelengths = hero_wavelengths<4>(distribution, random.next_float());
                const auto xyz = numbers(sensor.sense(wavelengths, sample(light, wavelengths)));
                for (std::size_t k = 0; k < 3; ++k) {
                    sum[k] += xyz[k];
                    squares[k] += xyz[k] * xyz[k];
                }
            }
            const auto expected = components(expected_xyz(options, light));
            const double size = std::abs(expected[0]) + std::abs(expected[1]) + std::abs(expected[2]);
            for (std::size_t k = 0; k < 3; ++k) {
                const double mean = sum[k] / kSeeds;
                const double margin =
                    4.40 * std::sqrt((squares[k] / kSeeds - mean * mean) / kSeeds) + 4e-6 * size;  // rounding
                EXPECT_LT(std::abs(mean - expected[k]), margin) << name << ", component " << k;
                if (light == lights().front() && k == 1) {
                    EXPECT_LT(margin, 0.03 * expected[k]) << name;
                }
            }
        }
    }
}

// The default is what it was before sensors had options: 683 times the 1931 functions, start and slope in floats.
TEST(EverySensor, DefaultIsThe1931ObserverToTheBit) {
    const Sensor sensor;
    Pcg32 random(3);
    for (int i = 0; i < 20000; ++i) {
        SampledWavelengths<1> wavelengths;
        wavelengths.lambda_nm = {360.0f + 470.0f * random.next_float()};
        wavelengths.pdf = {0.001f + random.next_float()};
        const float radiance = random.next_float();
        const float above = wavelengths.lambda_nm[0] - 360.0f;
        const int cell = std::min(static_cast<int>(above), 469);
        const float fraction = above - static_cast<float>(cell), scaled = radiance / wavelengths.pdf[0];
        const auto component = [&](double XYZd::*c) {
            const double start = kLuminousEfficacy * (eval(cie_1931_2deg(), 360 + cell).*c);
            const double end = kLuminousEfficacy * (eval(cie_1931_2deg(), 361 + cell).*c);
            return scaled * (static_cast<float>(start) + fraction * static_cast<float>(end - start));
        };
        const SensorSample seen = sensor.sense(wavelengths, SampledSpectrum<1>(radiance));
        ASSERT_EQ(seen.xyz, (XYZ{component(&XYZd::x), component(&XYZd::y), component(&XYZd::z)}));
        ASSERT_EQ(seen.luminance, seen.xyz.y);
        ASSERT_EQ(sensor.to_xyz(wavelengths, SampledSpectrum<1>(radiance)), seen.xyz);
    }
}

// The 2015 functions start at 390 nm, with a jump.
TEST(EverySensor, TablesJumpAtTheirEnds) {
    const Sensor sensor({.observer = "2015"});
    EXPECT_EQ(sensor.response(389.999), XYZd{});
    EXPECT_EQ(sensor.response(390.0), kLuminousEfficacy * eval(cie_2015_2deg(), 390.0));
    EXPECT_GT(sensor.response(390.0).z, 1.0);
}

}  // namespace
}  // namespace emulsion
