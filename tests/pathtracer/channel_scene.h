#pragma once
// Spectra to try fixed channels on, and what becomes of them.

#include <string>
#include <vector>

#include "pathtracer/fixed_channels.h"
#include "pathtracer/transport_model.h"
#include "spectrum/catalogue.h"

namespace emulsion::testing {

/// One of each kind of channels, and more where there are more.
inline std::vector<TransportModel> fixed_models() {
    return {RgbModel{},    RgbModel{"Rec2020"}, RgbModel{"sharp"}, PrefilteredRgbModel{},
            BasisModel{3}, BasisModel{4},       BasisModel{6},     BasisModel{8}};
}

/// The 24 patches.
inline std::vector<Spectrum> color_checker() {
    std::vector<Spectrum> patches;
    for (const NamedSpectrumInfo& entry : spectrum_catalogue()) {
        if (entry.name.starts_with("colorchecker-")) patches.emplace_back(spectrum_of(entry));
    }
    return patches;
}

/// What is left of a light after these reflections.
inline ChannelValues reflected(const FixedChannels& channels, const Spectrum& light,
                               const std::vector<Spectrum>& reflectances) {
    ChannelValues values = light_values(channels, light);
    for (const Spectrum& reflectance : reflectances) {
        const auto r = property_values(channels, reflectance);
        for (std::size_t k = 0; k < values.size(); ++k) values[k] *= r[k];
    }
    return values;
}

inline XYZd xyz_of(const FixedChannels& channels, const ChannelValues& values) {
    XYZd sum{};
    for (std::size_t k = 0; k < channels.size(); ++k) {
        const auto& [x, y, z] = channels[k].xyz;
        sum = sum + values[k] * XYZd{x, y, z};
    }
    return sum;
}

}  // namespace emulsion::testing
