#include "spectrum/wavelength_sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>

#include "core/random.h"

namespace emulsion {
namespace {

constexpr float kLargestFloat = 1.0f - 0x1p-24f;
constexpr std::array kNumbers = {0.0f, 0x1p-24f, 0.1f, 0.25f, 0.49999f, 0.5f, 0.77f, kLargestFloat};

template <std::size_t N>
void expect_one_in_each_stratum(std::array<double, N> numbers, float u) {
    std::sort(numbers.begin(), numbers.end());
    for (std::size_t i = 0; i < N; ++i) {
        EXPECT_GE(numbers[i], static_cast<double>(i) / N) << N << ' ' << u;
        EXPECT_LT(numbers[i], static_cast<double>(i + 1) / N) << N << ' ' << u;
    }
}

TEST(Arrangements, IndependentTakesTheNumbersAsTheyCome) {
    for_each_wavelength_count([]<int N>() {
        Pcg32 source(3), same(3);
        const auto numbers = IndependentArrangement::numbers<N>([&] { return source.next_float(); });
        for (const double number : numbers) EXPECT_EQ(number, static_cast<double>(same.next_float()));
        EXPECT_EQ(source.next(), same.next()) << "as many as there are wavelengths";
    });
}

TEST(Arrangements, StratifiedPutsOneInEachStratum) {
    for_each_wavelength_count([]<int N>() {
        for (const float u : kNumbers) {
            expect_one_in_each_stratum(StratifiedArrangement::numbers<N>([u] { return u; }), u);
        }
        Pcg32 source(3), same(3);
        const auto numbers = StratifiedArrangement::numbers<N>([&] { return source.next_float(); });
        for (std::size_t i = 0; i < N; ++i) {
            EXPECT_EQ(numbers[i] * N - static_cast<double>(i), static_cast<double>(same.next_float()));
        }
    });
}

// Exactly: u on the grid of 2^-24, and i/N, are sums of powers of two.
TEST(Arrangements, HeroRotatesByOneNth) {
    for_each_wavelength_count([]<int N>() {
        for (const float u : kNumbers) {
            const auto numbers = HeroArrangement::numbers<N>(u);
            EXPECT_EQ(numbers[0], static_cast<double>(u)) << "the first is u itself";
            expect_one_in_each_stratum(numbers, u);
            for (std::size_t i = 0; i < N; ++i) {
                const double back = numbers[i] - numbers[0] - static_cast<double>(i) / N;
                EXPECT_TRUE(back == 0.0 || back == -1.0) << back;
            }
        }
        int calls = 0;
        EXPECT_EQ(HeroArrangement::numbers<N>([&] { return ++calls, 0.3f; }), HeroArrangement::numbers<N>(0.3f));
        EXPECT_EQ(calls, 1);
    });
}

TEST(HeroWavelengths, AreTheDensitysAtTheRotatedNumbers) {
    const VisibleWavelengthPdf distribution;
    for_each_wavelength_count([&]<int N>() {
        for (const float u : kNumbers) {
            const SampledWavelengths<N> wavelengths = hero_wavelengths<N>(distribution, u);
            const auto numbers = HeroArrangement::numbers<N>(u);
            for (std::size_t i = 0; i < N; ++i) {
                const auto lambda_nm = static_cast<double>(wavelengths.lambda_nm[i]);
                EXPECT_NEAR(lambda_nm, distribution.sample_nm(numbers[i]), 1e-4);
                EXPECT_GE(lambda_nm, kMinWavelength_nm);
                EXPECT_LE(lambda_nm, kMaxWavelength_nm);
                EXPECT_GT(wavelengths.pdf[i], 0.0f);
            }
        }
    });
}

}  // namespace
}  // namespace emulsion
