#pragma once
// Drawing the wavelengths of a path: N numbers in [0, 1), arranged in one of three ways, go through the inverse of a
// distribution function (wavelength_pdf.h). Structures of arrays, and no branches by wavelength.
//
// The arrangements, by the random numbers that they take and how evenly these lie:
//   independent   N numbers as they come
//   stratified    N numbers, the i-th in [i/N, (i+1)/N)
//   hero          one number u, the i-th is u + i/N, less 1 where that is past 1
// Each number by itself is uniform on [0, 1), or on its stratum; a number picked from the N at random always is. That
// makes the sensor's estimate (1/N) sum_i radiance_i / pdf_i * response(lambda_i) unbiased.
//
// Numbers come from `next_u`, called as often as numbers are taken: a random generator or, better, further dimensions
// of the path's sample sequence. We don't make N numbers out of one: a float has 24 random bits, hashing them gives no
// more, and rotation is what can be done with one number.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "spectrum/sampled_spectrum.h"
#include "spectrum/wavelength_lines.h"
#include "spectrum/wavelength_pdf.h"

namespace emulsion {

/// A callable that gives the next uniform number in [0, 1).
template <class T>
concept UniformSource = std::is_invocable_r_v<float, T&>;

/// The numbers of N wavelengths, in [0, 1); in double precision, where sums such as u + i/N are exact.
template <int N>
using WavelengthNumbers = std::array<double, N>;

/// Every number by itself.
struct IndependentArrangement {
    template <int N, UniformSource Source>
    [[nodiscard]] static WavelengthNumbers<N> numbers(Source&& next_u) {
        WavelengthNumbers<N> numbers;
        for (double& number : numbers) number = static_cast<double>(next_u());
        return numbers;
    }
};

/// One in each of N equal strata, anywhere in it.
struct StratifiedArrangement {
    template <int N, UniformSource Source>
    [[nodiscard]] static WavelengthNumbers<N> numbers(Source&& next_u) {
        WavelengthNumbers<N> numbers;
        for (std::size_t i = 0; i < N; ++i) {
            numbers[i] = (static_cast<double>(i) + static_cast<double>(next_u())) / N;
        }
        return numbers;
    }
};

/// The first is u, the others are rotated by 1/N each, so that every stratum holds one, all at the same place in it.
/// Source: Wilkie et al., "Hero Wavelength Spectral Sampling", EGSR 2014.
struct HeroArrangement {
    template <int N>
    [[nodiscard]] static WavelengthNumbers<N> numbers(float u) noexcept {
        WavelengthNumbers<N> numbers;
        for (std::size_t i = 0; i < N; ++i) {
            const double rotated = static_cast<double>(u) + static_cast<double>(i) / N;
            // Less its whole part, 0 or 1: a comparison would become a branch, and half of the guesses at it wrong.
            numbers[i] = rotated - static_cast<double>(static_cast<std::int32_t>(rotated));
        }
        return numbers;
    }
    template <int N, UniformSource Source>
    [[nodiscard]] static WavelengthNumbers<N> numbers(Source&& next_u) {
        return numbers<N>(static_cast<float>(next_u()));
    }
};

/// The wavelengths at these numbers.
template <std::size_t N, class Pdf>
[[nodiscard]] SampledWavelengths<static_cast<int>(N)> wavelengths_at(const Pdf& distribution,
                                                                     const std::array<double, N>& numbers) noexcept {
    SampledWavelengths<static_cast<int>(N)> wavelengths;
    for (std::size_t i = 0; i < N; ++i) {
        const WavelengthSample sample = distribution.sample(numbers[i]);
        wavelengths.lambda_nm[i] = sample.lambda_nm;
        wavelengths.pdf[i] = sample.pdf;
    }
    return wavelengths;
}

/// The same, some of which may be lines.
template <std::size_t N>
[[nodiscard]] SampledLineWavelengths<static_cast<int>(N)> wavelengths_at(
    const LineWavelengthPdf& distribution, const std::array<double, N>& numbers) noexcept {
    SampledLineWavelengths<static_cast<int>(N)> wavelengths;
    for (std::size_t i = 0; i < N; ++i) {
        const WavelengthCells::Sample sample = distribution.sample(numbers[i]);
        wavelengths.lambda_nm[i] = sample.lambda_nm;
        wavelengths.pdf[i] = sample.pdf;
        wavelengths.line[i] = sample.line;
    }
    return wavelengths;
}

/// Draws N wavelengths from one uniform number u in [0, 1), by rotation.
template <int N, class Pdf>
[[nodiscard]] auto hero_wavelengths(const Pdf& distribution, float u) noexcept {
    return wavelengths_at(distribution, HeroArrangement::numbers<N>(u));
}

}  // namespace emulsion
