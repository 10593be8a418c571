#pragma once
// What one path carries: N wavelengths with the densities they were drawn with, and N values at those wavelengths.

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace emulsion {

/// The numbers of wavelengths per path that the library is compiled for.
inline constexpr std::array<int, 6> kWavelengthCounts = {1, 2, 4, 8, 16, 32};

/// Calls visitor.template operator()<N>() for each of them: visitor is a lambda []<int N>() { ... }.
template <class Visitor>
constexpr void for_each_wavelength_count(Visitor&& visitor) {
    [&]<std::size_t... I>(std::index_sequence<I...>) { (visitor.template operator()<kWavelengthCounts[I]>(), ...); }
    (std::make_index_sequence<kWavelengthCounts.size()>{});
}

/// N wavelengths of one path.
template <int N>
struct SampledWavelengths {
    std::array<float, N> lambda_nm{};  ///< in [kMinWavelength_nm, kMaxWavelength_nm]
    std::array<float, N> pdf{};        ///< density each was drawn with, 1/nm; > 0, or 0: the path has given it up
};

/// N values at the wavelengths of one path: a radiance in W m^-2 sr^-1 nm^-1, a reflectance, a throughput.
template <int N>
struct SampledSpectrum {
    alignas(N == 3 ? 4 : N >= 4 ? 16 : 4 * N) std::array<float, N> value{};

    SampledSpectrum() = default;
    explicit constexpr SampledSpectrum(float constant) noexcept { value.fill(constant); }

    [[nodiscard]] constexpr float& operator[](int i) noexcept { return value[static_cast<std::size_t>(i)]; }
    [[nodiscard]] constexpr float operator[](int i) const noexcept { return value[static_cast<std::size_t>(i)]; }
    bool operator==(const SampledSpectrum&) const = default;

    constexpr SampledSpectrum& operator+=(const SampledSpectrum& b) noexcept {
        for (int i = 0; i < N; ++i) (*this)[i] += b[i];
        return *this;
    }
    constexpr SampledSpectrum& operator*=(const SampledSpectrum& b) noexcept {
        for (int i = 0; i < N; ++i) (*this)[i] *= b[i];
        return *this;
    }
    constexpr SampledSpectrum& operator*=(float s) noexcept {
        for (int i = 0; i < N; ++i) (*this)[i] *= s;
        return *this;
    }
    friend constexpr SampledSpectrum operator+(SampledSpectrum a, const SampledSpectrum& b) noexcept { return a += b; }
    friend constexpr SampledSpectrum operator*(SampledSpectrum a, const SampledSpectrum& b) noexcept { return a *= b; }
    friend constexpr SampledSpectrum operator*(SampledSpectrum a, float s) noexcept { return a *= s; }
    friend constexpr SampledSpectrum operator*(float s, SampledSpectrum a) noexcept { return a *= s; }

    [[nodiscard]] constexpr float max() const noexcept { return *std::max_element(value.begin(), value.end()); }
};

}  // namespace emulsion
