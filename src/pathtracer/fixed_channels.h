#pragma once
// K numbers in the place of a spectrum, the same K for all paths: what the RGB models and the basis model have in
// common. Each number is a sum over whole nanometres n of the visible, from kMinWavelength_nm to kMaxWavelength_nm:
//
//     light E           l_k = sum_n h_kn E_n       E_n: node_integrals(), in what E is per, times nm
//     reflectance R     r_k = sum_n u_kn R(n)      1 for the perfect reflector: the u_kn add up to 1
//     back to CIE XYZ   sum_k l_k xyz_k            Y in cd/m^2
//
// which are exact integrals for weights, and reflectances, with straight lines between whole nanometres. What light
// becomes on a path is the product of these numbers, channel by channel. For one bounce that is right if l_k r_k is the
// light's number for E R; the models differ in their weights, and so in the E and R that it holds for.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/matrix3.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// The numbers of channels that paths are compiled for: RGB, bases, and pilots of many models together.
inline constexpr std::array kFixedChannelCounts = {3, 4, 8, 64};
inline constexpr int kMostFixedChannels = kFixedChannelCounts.back();

/// The least of them that has room for `count` channels in [1, kMostFixedChannels]; the rest is 0.
[[nodiscard]] constexpr int compiled_channels(int count) noexcept {
    for (const int compiled : kFixedChannelCounts) {
        if (count <= compiled) return compiled;
    }
    return kMostFixedChannels;
}

struct FixedChannel {
    std::vector<double> light;        ///< h_k; kWholeNanometres
    std::vector<double> reflectance;  ///< u_k; as many
    std::array<double, 3> xyz{};      ///< xyz_k
    /// Set if pictures are to be taken for colours of the channel itself: its row of a matrix from XYZ.
    std::optional<std::array<double, 3>> colour_from_xyz = std::nullopt;
};

/// At most kMostFixedChannels.
using FixedChannels = std::vector<FixedChannel>;

/// One number for each channel; those past the last are 0.
using ChannelValues = std::array<double, kMostFixedChannels>;

/// Of a light. \throws std::invalid_argument as node_integrals().
[[nodiscard]] ChannelValues light_values(const FixedChannels& channels, const Spectrum& light);

/// Of a reflectance, or any other property of a surface.
[[nodiscard]] ChannelValues property_values(const FixedChannels& channels, const Spectrum& property);

/// Weights that add up to 1, in proportion to those given; to their magnitudes, where they cancel out.
[[nodiscard]] std::vector<double> normalised_weights(std::vector<double> weights);

/// Three linear channels, reflectances as under `illuminant`.
/// \throws std::invalid_argument if the matrix has no inverse, and as node_integrals().
[[nodiscard]] FixedChannels linear_channels(const Matrix3& channels_from_xyz, const Spectrum& illuminant);

}  // namespace emulsion
