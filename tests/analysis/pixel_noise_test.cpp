#include "analysis/pixel_noise.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/units.h"
#include "pathtracer/spectrum_nodes.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/colorimetry.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum_table.h"
#include "spectrum/wavelength_importance.h"
#include "spectrum/wavelength_strategy.h"

namespace emulsion {
namespace {

/// 1 nm wide at half its height.
Spectrum line_at(double lambda_nm) {
    return PiecewiseLinearSpectrum{{lambda_nm - 1.0, lambda_nm, lambda_nm + 1.0}, {0.0, 1.0, 0.0}};
}

std::vector<WavelengthSampler> all_samplers(const Spectrum& light) {
    std::vector<WavelengthSampler> samplers;
    for_each_alternative<WavelengthStrategy>(
        [&](auto strategy) { samplers.push_back(prepare(strategy, wavelength_importance(light))); });
    return samplers;
}

/// A grey pixel in a light: what it shows, and how it is looked at.
struct GreyPixel {
    explicit GreyPixel(const Spectrum& of_light)
        : light(of_light),
          expected{.xyz = xyz_of_radiance(of_light)},
          viewing{{0.95, 1.0, 1.09}, expected.xyz.y / 0.18} {}

    [[nodiscard]] std::vector<XYZd> by_number(const WavelengthSampler& sampler) const {
        return WavelengthWeights(sampler, light)
            .by_number(std::vector<double>(node_integrals(light).size(), kLuminousEfficacy));
    }
    [[nodiscard]] double noise(const WavelengthSampler& sampler, int wavelengths, const PixelPaths& paths,
                               int pictures) const {
        return wavelength_noise(expected, by_number(sampler), sampler, wavelengths, paths, viewing,
                                {.pictures = pictures, .seed = 1});
    }

    Spectrum light;
    PixelLight expected;
    ViewingConditions viewing;
};

// Within 3 % of the integral: cells of u are up to 1/2 nm wide where hero-visible seldom is.
TEST(WavelengthWeights, MissNoLine) {
    for (double lambda_nm = 420.0; lambda_nm <= 700.0; lambda_nm += 7.3) {
        const GreyPixel pixel(line_at(lambda_nm));
        for (const WavelengthSampler& sampler : all_samplers(pixel.light)) {
            XYZd mean{};
            for (const XYZd& one : pixel.by_number(sampler)) mean = mean + 1.0 / kNumberCells * one;
            EXPECT_NEAR(mean.x, pixel.expected.xyz.x, 0.03 * pixel.expected.xyz.x) << lambda_nm;
            EXPECT_NEAR(mean.y, pixel.expected.xyz.y, 0.03 * pixel.expected.xyz.y) << lambda_nm;
            EXPECT_NEAR(mean.z, pixel.expected.xyz.z, 0.03 * pixel.expected.xyz.z + 1e-4) << lambda_nm;
        }
    }
}

constexpr int kPathsOfPixel = 64, kPixels = 15625;  // 1e6 draws

/// Paths as render() draws them, one after another.
template <int N>
double by_brute_force(const GreyPixel& pixel, const WavelengthSampler& sampler) {
    const SpectrumTable table(pixel.light);
    const Lab expected = lab_as_viewed(pixel.expected.xyz, pixel.viewing);
    Pcg32 random(7);
    double sum = 0.0;
    for (int i = 0; i < kPixels; ++i) {
        XYZd colour{};
        for (int path = 0; path < kPathsOfPixel; ++path) {
            const SampledWavelengths<N> drawn = sample_wavelengths<N>(sampler, [&] { return random.next_float(); });
            const SampledSpectrum<N> radiance = table.at(SpectrumTableIndex<N>(drawn.lambda_nm));
            for (std::size_t k = 0; k < N; ++k) {
                const double scale = kLuminousEfficacy / (N * kPathsOfPixel * static_cast<double>(drawn.pdf[k]));
                colour = colour + scale * static_cast<double>(radiance[static_cast<int>(k)]) *
                                      eval(cie_1931_2deg(), static_cast<double>(drawn.lambda_nm[k]));
            }
        }
        const double e = difference(Ciede2000Difference{}, expected, lab_as_viewed(colour, pixel.viewing));
        sum += e * e / kPixels;
    }
    return sum;
}

// Both are means of 15625 squares that are about as large as they scatter: 4 standard errors of their difference are
// 4 sqrt(2 / 15625) = 4.5 %.
TEST(WavelengthNoise, AgreesWithAMillionDraws) {
    const GreyPixel pixel(line_at(589.0));
    const PixelPaths paths{kPathsOfPixel, PixelPaths::Numbers::independent};
    for (const WavelengthSampler& sampler : all_samplers(pixel.light)) {
        const double one = by_brute_force<1>(pixel, sampler), four = by_brute_force<4>(pixel, sampler);
        EXPECT_NEAR(pixel.noise(sampler, 1, paths, kPixels), one, 0.045 * one) << sampler.index();
        EXPECT_NEAR(pixel.noise(sampler, 4, paths, kPixels), four, 0.045 * four) << sampler.index();
    }
}

TEST(WavelengthNoise, NeverRisesWithTheNumberOfWavelengths) {
    const GreyPixel pixel(line_at(589.0));
    for (const auto numbers : {PixelPaths::Numbers::independent, PixelPaths::Numbers::even}) {
        for (const WavelengthSampler& sampler : all_samplers(pixel.light)) {
            double last = std::numeric_limits<double>::infinity();
            for (const int n : kWavelengthCounts) {
                const double noise = pixel.noise(sampler, n, {4096.0, numbers}, 4000);
                EXPECT_LE(noise, last) << n << " of strategy " << sampler.index();
                EXPECT_GT(noise, 0.0);
                last = noise;
            }
        }
    }
}

TEST(WavelengthNoise, KnowingTheLinePays) {
    const GreyPixel pixel(line_at(589.0));
    const WavelengthImportance importance = wavelength_importance(pixel.light);
    const double blind = pixel.noise(prepare(HeroVisible{}, importance), 4, {}, 1000),
                 knowing = pixel.noise(prepare(HeroIlluminant{}, importance), 4, {}, 1000);
    EXPECT_LT(knowing, 0.1 * blind);
}

TEST(WavelengthNoise, DispersedLightIsThatOfOneWavelength) {
    GreyPixel pixel(Spectrum{ConstantSpectrum{1.0}});
    const WavelengthSampler sampler = prepare(HeroVisible{}, wavelength_importance(pixel.light));
    const PixelPaths paths{64.0, PixelPaths::Numbers::independent};
    const double one = pixel.noise(sampler, 1, paths, 1000), eight = pixel.noise(sampler, 8, paths, 1000);
    pixel.expected.dispersed_share = 1.0;
    EXPECT_DOUBLE_EQ(pixel.noise(sampler, 8, paths, 1000), one);
    pixel.expected.dispersed_share = 0.3;
    const double some = pixel.noise(sampler, 8, paths, 1000);
    EXPECT_GT(some, 2.0 * eight);
    EXPECT_LT(some, 0.5 * one);
}

// A grey of 18 % of white: dL* = 116/3 0.18^(1/3) of a relative change, and CIEDE2000 weighs it by 1 / S_L, here 1.00.
TEST(ChannelNoise, IsThatOfLuminance) {
    const XYZd white{0.95, 1.0, 1.09};
    const PixelLight light{.xyz = 0.18 * white, .path_variance = 2.0};
    const PixelPaths paths{1e4};
    const double relative = std::sqrt(2.0 / 1e4), expected = 116.0 / 3.0 * std::cbrt(0.18) * relative;
    EXPECT_NEAR(std::sqrt(channel_noise(light, paths, {white, 1.0}, {.pictures = 4000})), expected, 0.05 * expected);
    EXPECT_EQ(channel_noise({.xyz = light.xyz}, paths, {white, 1.0}), 0.0);
}

}  // namespace
}  // namespace emulsion
