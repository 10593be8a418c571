#pragma once
// The fast twin of SigmoidFit: sigmoid coefficients looked up in a table, in single precision, and evaluated at the
// wavelengths of a path. For textures: nothing is allocated, nothing throws.
//
// The table is indexed by the largest of red, green and blue, by its value z, and by the next two components in the
// cycle red, green, blue divided by z, y and x. Nodes lie closer at both ends of each axis. It holds the centred
// coefficients (sigmoid.h) times sqrt(z): dark colours of one chromaticity then differ little. Between nodes it is
// linear in the node's number.
//
// Tolerance, sRGB: the colour of the result differs from the one asked for by at most 0.4 CIELAB (CIE 1976), 0.05 in
// the mean, over 40,000 random colours; docs/rgb-uplift.md has the other spaces. Greys are exactly constant. The
// spectra differ little where they are seen; but the exact solver's jump, at the ends of the visible and for light
// colours all over it, between sigmoids that look the same.
//
// Source: Jakob & Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling", EG 2019, section 4.
// Ours departs from theirs in the node spacing (theirs is smoothstep(smoothstep) along z and even along x and y), in
// the factor sqrt(z) and in the interpolation: so 32 nodes an axis are enough where they take 64.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "core/color.h"
#include "spectrum/rgb_space.h"
#include "spectrum/sampled_spectrum.h"
#include "spectrum/sigmoid.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// The spaces whose tables are compiled in, in the order of the embedded data.
inline constexpr std::array<std::string_view, 5> kSigmoidTableSpaces = {"sRGB", "Rec2020", "ACEScg_AP1", "Display_P3",
                                                                        "ACES2065_1_AP0"};

/// Nodes along each axis of the embedded tables.
inline constexpr int kSigmoidTableResolution = 32;

/// A reflectance in [0, 1] as the renderer keeps it: centred coefficients; an infinite k[2] stands for 0 and 1.
struct SigmoidCoefficients {
    std::array<float, 3> k{};
    bool operator==(const SigmoidCoefficients&) const = default;
};

/// Within 2e-5 of the double-precision twin, eval(Spectrum) of sigmoid_of(coefficients).
template <int N>
[[nodiscard]] SampledSpectrum<N> eval(const SigmoidCoefficients& sigmoid_k,
                                      const std::array<float, N>& lambda_nm) noexcept {
    SampledSpectrum<N> values;
    for (std::size_t i = 0; i < N; ++i) {
        const float s =
            (lambda_nm[i] - static_cast<float>(kSigmoidCentre_nm)) * static_cast<float>(1 / kSigmoidWidth_nm);
        values.value[i] = sigmoid((sigmoid_k.k[0] * s + sigmoid_k.k[1]) * s + sigmoid_k.k[2]);
    }
    return values;
}

/// The same function as a Spectrum.
[[nodiscard]] SigmoidSpectrum sigmoid_of(const SigmoidCoefficients& coefficients) noexcept;

/// scale * sigmoid: an unbounded RGB colour, or, times the space's illuminant, an RGB light.
struct ScaledSigmoid {
    SigmoidCoefficients sigmoid;
    float scale = 0.0f;
};

class SigmoidTable {
  public:
    /// An embedded table, by the space's primaries and white: Rec709 has that of sRGB.
    /// \throws std::invalid_argument for a space that has none, naming those that do.
    explicit SigmoidTable(const RgbSpace& space);

    /// What solve_sigmoid_table gives.
    /// \throws std::invalid_argument if the resolution is below 2 or does not fit the size.
    SigmoidTable(std::vector<float> coefficients, int resolution);

    /// The reflectance of a linear RGB colour in [0, 1]^3. Components outside are taken for the nearer of 0 and 1, NaN
    /// for 0: callers who want an error use RgbUplift.
    [[nodiscard]] SigmoidCoefficients reflectance(const RGB& rgb) const noexcept;

    /// As pbrt-v4 takes colours without an upper bound: with m the largest component, scale = 2 m and the sigmoid of
    /// rgb / (2 m). Scale 0 if no component is above 0, infinite if one is above half the largest float.
    [[nodiscard]] ScaledSigmoid unbounded(const RGB& rgb) const noexcept;

  private:
    std::vector<float> coefficients_;
    int resolution_;
};

/// Where a table's nodes lie: the value in [0, 1] of the node at u = number / (resolution - 1), and back.
template <class T>
[[nodiscard]] T sigmoid_table_value(T u) noexcept {
    return u < T(0.5) ? T(2) * u * u : T(1) - T(2) * (T(1) - u) * (T(1) - u);
}
template <class T>
[[nodiscard]] T sigmoid_table_position(T value) noexcept {
    const T root = std::sqrt(T(0.5) * std::min(value, T(1) - value));
    return value < T(0.5) ? root : T(1) - root;
}

/// The compiled-in tables, one after the other.
[[nodiscard]] std::span<const float> embedded_sigmoid_tables() noexcept;

}  // namespace emulsion
