#include "pathtracer/model_channels.h"

#include "spectrum/reflectance_weights.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

namespace {

std::optional<FixedChannels> channels(const SpectralModel& /*model*/, const SceneSpectra& /*scene*/) { return {}; }
std::optional<FixedChannels> channels(const RgbModel& model, const SceneSpectra& /*scene*/) {
    return rgb_channels(model.space);
}
std::optional<FixedChannels> channels(const PrefilteredRgbModel& /*model*/, const SceneSpectra& scene) {
    return linear_channels(channel_space_from_xyz(kSharpChannels), sum_of_lights(scene));
}
std::optional<FixedChannels> channels(const BasisModel& model, const SceneSpectra& scene) {
    return basis_channels(scene, model.functions);
}

}  // namespace

std::optional<FixedChannels> channels_of(const TransportModel& model, const SceneSpectra& scene) {
    validate(model);
    return std::visit([&scene](const auto& m) { return channels(m, scene); }, model);
}

FixedChannels rgb_channels(std::string_view space) {
    // Sharp channels have no white of their own: that of sRGB, which colours without a space are of.
    FixedChannels result = linear_channels(channel_space_from_xyz(space),
                                           illuminant_of(rgb_space(space == kSharpChannels ? "sRGB" : space)));
    const Matrix3 rgb_from_xyz = channel_space_from_xyz(space);
    for (std::size_t k = 0; k < 3; ++k) result[k].colour_from_xyz = rgb_from_xyz.m[k];
    return result;
}

}  // namespace emulsion
