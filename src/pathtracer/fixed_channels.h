#pragma once
// K numbers in the place of a spectrum, the same K for all paths: what the RGB models and the basis model have in
// common. Each number is an integral:
//
//     light E           l_k = integral of E h_k                        in what E is per, times that of h_k
//     reflectance R     r_k = integral of R I g_k / integral of I g_k  1 for the perfect reflector
//     back to CIE XYZ   sum_k l_k xyz_k                                Y in cd/m^2
//
// What light becomes on a path is the product of these numbers, channel by channel. For one bounce that is right if
// l_k r_k is the integral of E R h_k; the models differ in which I, g and h they choose, and so in which E and R it
// holds for.

#include <array>
#include <optional>
#include <vector>

#include "core/matrix3.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// The most channels that a path is compiled for.
inline constexpr int kMostFixedChannels = 8;

struct FixedChannels {
    struct Channel {
        DenseSpectrum light;          ///< h_k; straight lines between whole nanometres
        DenseSpectrum reflectance;    ///< g_k
        std::array<double, 3> xyz{};  ///< xyz_k
    };
    std::vector<Channel> channel;         ///< at most kMostFixedChannels
    Spectrum illuminant;                  ///< I
    std::optional<Matrix3> rgb_from_xyz;  ///< set if pictures are to be taken for colours of the channels themselves

    [[nodiscard]] int count() const noexcept { return static_cast<int>(channel.size()); }
};

/// One number for each channel; those past the last are 0.
using ChannelValues = std::array<float, kMostFixedChannels>;

/// Of a light times `scale`. \throws std::invalid_argument as validate(Spectrum) does.
[[nodiscard]] ChannelValues light_values(const FixedChannels& channels, const Spectrum& light, double scale = 1.0);

/// Of a reflectance, or any other property of a surface; where I g_k has no integral to speak of, under equal energy.
/// In double precision. \throws std::invalid_argument as validate(Spectrum) does.
[[nodiscard]] std::array<double, kMostFixedChannels> property_values(const FixedChannels& channels,
                                                                     const Spectrum& property);

/// Three linear channels, reflectances as under `illuminant`.
/// \throws std::invalid_argument if the matrix has no inverse, or the illuminant is 0 in the visible.
[[nodiscard]] FixedChannels linear_channels(const Matrix3& channels_from_xyz, Spectrum illuminant);

}  // namespace emulsion
