#include "pathtracer/fixed_channels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/units.h"
#include "spectrum/integral.h"
#include "spectrum/observer.h"

namespace emulsion {

namespace {

constexpr auto kMin_nm = static_cast<double>(kMinWavelength_nm), kMax_nm = static_cast<double>(kMaxWavelength_nm);

/// A row of a matrix times the observer's functions: straight lines between whole nanometres, as these are.
DenseSpectrum response(const std::array<double, 3>& row, double scale) {
    DenseSpectrum sum{kMin_nm, 1.0, {}};
    for (int lambda_nm = kMinWavelength_nm; lambda_nm <= kMaxWavelength_nm; ++lambda_nm) {
        const XYZd xyz = eval(cie_1931_2deg(), static_cast<double>(lambda_nm));
        sum.value.push_back(scale * (row[0] * xyz.x + row[1] * xyz.y + row[2] * xyz.z));
    }
    return sum;
}

DenseSpectrum magnitude(DenseSpectrum spectrum) {
    for (double& value : spectrum.value) value = std::abs(value);
    return spectrum;
}

/// Mean of `property` weighted by illuminant * weight; unset if these cancel out.
std::optional<double> weighted_mean(const Spectrum& property, const Spectrum& illuminant, const DenseSpectrum& weight) {
    constexpr double kCancelled = 1e-4;
    const Spectrum w = weight, size = magnitude(weight);
    const double whole = integral_of_product({illuminant, w}, kMin_nm, kMax_nm);
    if (!(std::abs(whole) > kCancelled * integral_of_product({illuminant, size}, kMin_nm, kMax_nm))) return {};
    return integral_of_product({property, illuminant, w}, kMin_nm, kMax_nm) / whole;
}

}  // namespace

ChannelValues light_values(const FixedChannels& channels, const Spectrum& light, double scale) {
    ChannelValues values{};
    for (std::size_t k = 0; k < channels.channel.size(); ++k) {
        const Spectrum weight = channels.channel[k].light;
        values[k] = static_cast<float>(scale * integral_of_product({light, weight}, kMin_nm, kMax_nm));
    }
    return values;
}

std::array<double, kMostFixedChannels> property_values(const FixedChannels& channels, const Spectrum& property) {
    std::array<double, kMostFixedChannels> values{};
    for (std::size_t k = 0; k < channels.channel.size(); ++k) {
        const DenseSpectrum& weight = channels.channel[k].reflectance;
        const auto mean = weighted_mean(property, channels.illuminant, weight);
        values[k] = mean ? *mean : weighted_mean(property, ConstantSpectrum{1.0}, magnitude(weight)).value();
    }
    return values;
}

FixedChannels linear_channels(const Matrix3& channels_from_xyz, Spectrum illuminant) {
    if (!(integral(illuminant, kMin_nm, kMax_nm) > 0.0)) {
        throw std::invalid_argument("illuminant: 0 in the visible, expected light");
    }
    const Matrix3 xyz_from_channels = inverse(channels_from_xyz);
    FixedChannels channels;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::array<double, 3>& row = channels_from_xyz.m[k];
        channels.channel.push_back({response(row, kLuminousEfficacy),
                                    response(row, 1.0),
                                    {xyz_from_channels.m[0][k], xyz_from_channels.m[1][k], xyz_from_channels.m[2][k]}});
    }
    channels.illuminant = std::move(illuminant);
    return channels;
}

}  // namespace emulsion
