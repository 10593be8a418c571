#include "spectrum/wavelength_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

namespace emulsion {
namespace {

// Integral of the density from 360 nm, by Simpson's rule on quarter nanometres.
double numeric_cdf(const VisibleWavelengthPdf& distribution, double lambda_nm) {
    const int steps = 4 * static_cast<int>(std::ceil(lambda_nm - kMinWavelength_nm)) + 4;
    const double step = (lambda_nm - kMinWavelength_nm) / steps;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double a = kMinWavelength_nm + i * step;
        sum += step / 6.0 *
               (distribution.pdf(a) + 4.0 * distribution.pdf(a + 0.5 * step) +
                distribution.pdf(std::min(a + step, 830.0)));
    }
    return sum;
}

TEST(VisibleWavelengthPdf, IntegratesToOne) {
    EXPECT_NEAR(numeric_cdf(VisibleWavelengthPdf(), kMaxWavelength_nm), 1.0, 1e-11);
}

TEST(VisibleWavelengthPdf, IsZeroOutsideAndPositiveInside) {
    const VisibleWavelengthPdf distribution;
    EXPECT_EQ(distribution.pdf(359.99), 0.0);
    EXPECT_EQ(distribution.pdf(830.01), 0.0);
    for (const double lambda_nm : {360.0, 538.0, 830.0}) EXPECT_GT(distribution.pdf(lambda_nm), 0.0);
    EXPECT_GT(distribution.pdf(538.0), 2.0 * distribution.pdf(400.0));
}

TEST(VisibleWavelengthPdf, SamplesInvertTheDistribution) {
    const VisibleWavelengthPdf distribution;
    for (int i = 0; i <= 64; ++i) {
        const double u = i / 64.0;
        EXPECT_NEAR(numeric_cdf(distribution, distribution.sample_nm(u)), u, 1e-10) << u;
    }
    EXPECT_NEAR(distribution.sample_nm(0.0), 360.0, 1e-9);
    EXPECT_NEAR(distribution.sample_nm(1.0), 830.0, 1e-9);
}

TEST(VisibleWavelengthPdf, FastSampleFollowsItsTwins) {
    const VisibleWavelengthPdf distribution;
    constexpr int kCount = 1 << 18;
    for (int i = 0; i < kCount; ++i) {
        const double u = (i + 0.5) / kCount;
        const VisibleWavelengthPdf::Sample sample = distribution.sample(u);
        const double lambda_nm = distribution.sample_nm(u), pdf = distribution.pdf(lambda_nm);
        ASSERT_NEAR(static_cast<double>(sample.lambda_nm), lambda_nm, 1e-4) << u;
        ASSERT_NEAR(static_cast<double>(sample.pdf), pdf, 1e-6 * pdf) << u;
    }
}

template <int N>
void expect_one_wavelength_per_stratum() {
    const VisibleWavelengthPdf distribution;
    constexpr double kRounding = 5e-7;  // 1e-4 nm, as seen in u
    for (const float u : {0.0f, 0.1f, 0.25f, 0.49999f, 0.5f, 0.77f, std::nextafter(1.0f, 0.0f)}) {
        const SampledWavelengths<N> wavelengths = sample_visible_wavelengths<N>(distribution, u);
        std::array<double, N> back{};
        for (std::size_t i = 0; i < N; ++i) {
            const auto lambda_nm = static_cast<double>(wavelengths.lambda_nm[i]);
            ASSERT_GE(lambda_nm, kMinWavelength_nm);
            ASSERT_LE(lambda_nm, kMaxWavelength_nm);
            const double pdf = distribution.pdf(lambda_nm);
            EXPECT_NEAR(static_cast<double>(wavelengths.pdf[i]), pdf, 1e-6 * pdf);
            back[i] = numeric_cdf(distribution, lambda_nm);
        }
        EXPECT_NEAR(back[0], static_cast<double>(u), kRounding) << "the first is that of u itself";
        std::sort(back.begin(), back.end());
        for (std::size_t i = 0; i < N; ++i) {
            EXPECT_GE(back[i], static_cast<double>(i) / N - kRounding) << N << ' ' << u;
            EXPECT_LE(back[i], static_cast<double>(i + 1) / N + kRounding) << N << ' ' << u;
        }
    }
}

TEST(SampleVisibleWavelengths, PutsOneInEachStratum) {
    expect_one_wavelength_per_stratum<1>();
    expect_one_wavelength_per_stratum<2>();
    expect_one_wavelength_per_stratum<4>();
    expect_one_wavelength_per_stratum<8>();
    expect_one_wavelength_per_stratum<16>();
    expect_one_wavelength_per_stratum<32>();
}

}  // namespace
}  // namespace emulsion
