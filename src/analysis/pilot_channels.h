#pragma once
// The channels of a pilot: narrow bands of wavelengths, which together are as good as exact, and beside them the
// channels of several models. Every path carries all of them, so that the models can be compared path by path.

#include <cstddef>
#include <span>
#include <vector>

#include "pathtracer/channel_basis.h"
#include "pathtracer/fixed_channels.h"
#include "pathtracer/transport_model.h"

namespace emulsion {

struct PilotChannels {
    /// Where the channels of one model lie among all.
    struct Part {
        std::size_t first = 0, count = 0;
    };
    FixedChannels all;                    ///< kMostFixedChannels of them
    Part bands;                           ///< of wavelengths, each X + Y + Z of what lies in it
    std::vector<double> band_end_nm;      ///< of each band; the first begins at the end of the visible
    std::vector<Part> models;             ///< of each model that was asked for
    std::size_t control = 0, marked = 0;  ///< two copies of ybar; the second loses what disperses
};

/// How many channels models may have together.
inline constexpr std::size_t kPilotBands = 36, kPilotModelChannels = kMostFixedChannels - kPilotBands - 2;

/// What the eye makes of each whole nanometre of the visible: xbar + ybar + zbar.
[[nodiscard]] std::vector<double> eye_nodes();

/// The bands are narrow where the light of the scene is, as the eye sees it. Models of fixed channels only.
/// \throws std::invalid_argument for a spectral model, and for more than kPilotModelChannels channels.
[[nodiscard]] PilotChannels pilot_channels(const SceneSpectra& scene, std::span<const TransportModel> models);

}  // namespace emulsion
