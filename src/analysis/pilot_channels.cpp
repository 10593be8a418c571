#include "analysis/pilot_channels.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/core.h>

#include "core/units.h"
#include "pathtracer/model_channels.h"
#include "pathtracer/spectrum_nodes.h"
#include "spectrum/observer.h"

namespace emulsion {

namespace {

using Nodes = std::vector<double>;

Nodes products(const Nodes& a, const Nodes& b) {
    Nodes result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::multiplies<>());
    return result;
}

/// One past the last nanometre of each band. Half of them go by the eye alone: other lights may be in the scene, too.
std::vector<std::size_t> band_ends(const Nodes& light, const Nodes& eye) {
    const Nodes seen = normalised_weights(products(light, eye)), anywhere = normalised_weights(eye);
    std::vector<std::size_t> ends;
    double sum = 0.0;
    for (std::size_t n = 0; n < seen.size(); ++n) {
        sum += 0.5 * (seen[n] + anywhere[n]);
        const std::size_t left = kPilotBands - ends.size();
        const bool full = sum * static_cast<double>(kPilotBands) >= static_cast<double>(ends.size() + 1);
        if (left > 1 && full) ends.push_back(n + 1);
    }
    ends.push_back(seen.size());
    return ends;
}

/// Its number is X + Y + Z of what lies within: what is lost is where in the band that is.
FixedChannel band(const Nodes& light, const Nodes& eye, std::size_t begin, std::size_t end) {
    FixedChannel channel;
    channel.light.assign(kWholeNanometres, 0.0);
    Nodes seen(kWholeNanometres, 0.0);
    for (std::size_t n = begin; n < end; ++n) {
        channel.light[n] = kLuminousEfficacy * eye[n];
        seen[n] = light[n] * eye[n];
    }
    if (!(std::accumulate(seen.begin(), seen.end(), 0.0) > 0.0)) {
        for (std::size_t n = begin; n < end; ++n) seen[n] = eye[n];
    }
    channel.reflectance = normalised_weights(std::move(seen));
    for (std::size_t n = begin; n < end; ++n) {
        const XYZd xyz = eval(cie_1931_2deg(), kMinWavelength_nm + static_cast<double>(n));
        const double share = channel.reflectance[n] / eye[n];
        channel.xyz[0] += share * xyz.x;
        channel.xyz[1] += share * xyz.y;
        channel.xyz[2] += share * xyz.z;
    }
    return channel;
}

FixedChannel luminance_channel(const Nodes& light) {
    FixedChannel channel;
    for (std::size_t n = 0; n < kWholeNanometres; ++n) {
        channel.light.push_back(eval(cie_1931_2deg(), kMinWavelength_nm + static_cast<double>(n)).y);
    }
    channel.reflectance = normalised_weights(products(channel.light, light));
    for (double& h : channel.light) h *= kLuminousEfficacy;
    return channel;
}

}  // namespace

std::vector<double> eye_nodes() {
    Nodes eye(kWholeNanometres);
    for (std::size_t n = 0; n < eye.size(); ++n) {
        const XYZd xyz = eval(cie_1931_2deg(), kMinWavelength_nm + static_cast<double>(n));
        eye[n] = xyz.x + xyz.y + xyz.z;
    }
    return eye;
}

PilotChannels pilot_channels(const SceneSpectra& scene, std::span<const TransportModel> models) {
    const Nodes light = node_integrals(sum_of_lights(scene)), eye = eye_nodes();
    PilotChannels pilot;
    std::size_t begin = 0;
    for (const std::size_t end : band_ends(light, eye)) {
        pilot.all.push_back(band(light, eye, begin, end));
        pilot.band_end_nm.push_back(kMinWavelength_nm + static_cast<double>(end));
        begin = end;
    }
    pilot.bands = {0, pilot.all.size()};
    for (const TransportModel& model : models) {
        const auto channels = channels_of(model, scene);
        if (!channels)
            throw std::invalid_argument("pilot: model " + to_text(model) + ", expected one of fixed channels");
        pilot.models.push_back({pilot.all.size(), channels->size()});
        pilot.all.insert(pilot.all.end(), channels->begin(), channels->end());
    }
    if (pilot.all.size() > kPilotBands + kPilotModelChannels) {
        throw std::invalid_argument(fmt::format("pilot: models of {} channels together, expected at most {}",
                                                pilot.all.size() - kPilotBands, kPilotModelChannels));
    }
    // Dispersing materials take the last channel from paths: all in between stay 0.
    pilot.control = pilot.all.size();
    pilot.marked = kMostFixedChannels - 1;
    pilot.all.push_back(luminance_channel(light));
    const FixedChannel unused{Nodes(kWholeNanometres, 0.0), Nodes(kWholeNanometres, 0.0)};
    pilot.all.resize(pilot.marked, unused);
    pilot.all.push_back(pilot.all[pilot.control]);
    return pilot;
}

}  // namespace emulsion
