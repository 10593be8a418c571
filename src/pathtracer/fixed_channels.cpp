#include "pathtracer/fixed_channels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/units.h"
#include "pathtracer/spectrum_nodes.h"
#include "spectrum/observer.h"

namespace emulsion {

namespace {

/// A row of a matrix times the observer's functions, at whole nanometres.
std::vector<double> response(const std::array<double, 3>& row) {
    std::vector<double> sum(kWholeNanometres);
    for (std::size_t n = 0; n < sum.size(); ++n) {
        const XYZd xyz = eval(cie_1931_2deg(), kMinWavelength_nm + static_cast<double>(n));
        sum[n] = row[0] * xyz.x + row[1] * xyz.y + row[2] * xyz.z;
    }
    return sum;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) noexcept {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

ChannelValues light_values(const FixedChannels& channels, const Spectrum& light) {
    const std::vector<double> nodes = node_integrals(light);
    ChannelValues values{};
    for (std::size_t k = 0; k < channels.size(); ++k) values[k] = dot(channels[k].light, nodes);
    return values;
}

ChannelValues property_values(const FixedChannels& channels, const Spectrum& property) {
    std::vector<double> lambda_nm(kWholeNanometres), at_nodes(kWholeNanometres);
    std::iota(lambda_nm.begin(), lambda_nm.end(), static_cast<double>(kMinWavelength_nm));
    eval(property, lambda_nm, at_nodes);
    ChannelValues values{};
    for (std::size_t k = 0; k < channels.size(); ++k) values[k] = dot(channels[k].reflectance, at_nodes);
    return values;
}

std::vector<double> normalised_weights(std::vector<double> weights) {
    constexpr double kCancelled = 1e-4;
    double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    const double size =
        std::accumulate(weights.begin(), weights.end(), 0.0, [](double s, double w) { return s + std::abs(w); });
    if (!(std::abs(sum) > kCancelled * size)) {
        std::transform(weights.begin(), weights.end(), weights.begin(), [](double w) { return std::abs(w); });
        sum = size;
    }
    // No light at all: every wavelength alike.
    if (!(std::abs(sum) > 0.0)) {
        std::fill(weights.begin(), weights.end(), 1.0);
        sum = static_cast<double>(weights.size());
    }
    for (double& w : weights) w /= sum;
    return weights;
}

FixedChannels linear_channels(const Matrix3& channels_from_xyz, const Spectrum& illuminant) {
    const Matrix3 xyz_from_channels = inverse(channels_from_xyz);
    FixedChannels channels;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<double> seen = response(channels_from_xyz.m[k]);
        FixedChannel& channel = channels.emplace_back();
        const Spectrum curve = DenseSpectrum{static_cast<double>(kMinWavelength_nm), 1.0, seen};
        channel.reflectance = normalised_weights(node_integrals(product_of(illuminant, curve)));
        channel.light = seen;
        for (double& h : channel.light) h *= kLuminousEfficacy;
        for (std::size_t i = 0; i < 3; ++i) channel.xyz[i] = xyz_from_channels.m[i][k];
    }
    return channels;
}

}  // namespace emulsion
