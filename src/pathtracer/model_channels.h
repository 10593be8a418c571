#pragma once
// The channels that a transport model stands for, in a given scene.

#include <optional>
#include <string_view>

#include "pathtracer/channel_basis.h"
#include "pathtracer/fixed_channels.h"
#include "pathtracer/transport_model.h"

namespace emulsion {

/// Unset for paths of wavelengths.
/// \throws std::invalid_argument as validate(TransportModel) does.
[[nodiscard]] std::optional<FixedChannels> channels_of(const TransportModel& model, const SceneSpectra& scene);

/// Those of RgbModel. \throws std::invalid_argument as channel_space_from_xyz().
[[nodiscard]] FixedChannels rgb_channels(std::string_view space);

}  // namespace emulsion
