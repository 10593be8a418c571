#pragma once
// A small render of a scene that tells how its light would look by several transport models: which lights meet which
// surfaces, and how often, as the camera sees it. All models are carried by the same paths, so that their differences
// have little noise.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/pilot_channels.h"
#include "core/color.h"
#include "pathtracer/prepared_scene.h"

namespace emulsion {

struct PilotOptions {
    int pixels = 1024;           ///< about; of the scene's crop, in its aspect; >= 1
    int samples_per_pixel = 16;  ///< >= 1
    std::uint64_t seed = 0;
    int threads = 0;  ///< >= 0; 0: one per hardware thread; no result depends on it
};

struct Pilot {
    PilotChannels channels;
    int width_px = 0, height_px = 0;
    std::vector<ChannelValues> pixels;    ///< means of the samples, row by row; Y in cd/m^2 of a film without exposure
    std::vector<double> luminance_error;  ///< standard error of each pixel's Y by its samples taken for independent
};

/// Prepares `scene` for the pilot's channels: it is prepared for no model afterwards.
/// \throws std::invalid_argument as pilot_channels(), and for options out of their range.
[[nodiscard]] Pilot trace_pilot(PreparedScene& scene, std::span<const TransportModel> models,
                                const PilotOptions& options);

/// What a part of a pixel's channels is as a colour.
[[nodiscard]] XYZd xyz_of(const PilotChannels& channels, const PilotChannels::Part& part, const ChannelValues& pixel);

}  // namespace emulsion
