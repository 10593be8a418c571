#pragma once
// A sample of a scene's picture that tells how its light would look by several transport models: which lights meet
// which surfaces, and how often, as the camera sees it. All models are carried by the same paths, so that their
// differences have little noise.
//
// The frame is divided into an even grid of cells, and of each cell one pixel is rendered as the film would have it, at
// a place that is drawn: what textures show of one another stays apart, and a grid of cells doesn't beat with theirs.
// A crop window is left out of account, so that parts of a picture are rendered alike.

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/pilot_channels.h"
#include "core/color.h"
#include "pathtracer/prepared_scene.h"

namespace emulsion {

struct PilotOptions {
    int pixels = 2048;            ///< about; of the whole frame, in its aspect; >= 1
    int samples_per_pixel = 128;  ///< >= 1
    std::uint64_t seed = 0;
    int threads = 0;  ///< >= 0; 0: one per hardware thread; no result depends on it
};

struct Pilot {
    PilotChannels channels;
    int width_px = 0, height_px = 0;
    int samples_per_pixel = 0;
    std::vector<ChannelValues> pixels;    ///< means of the samples, row by row; Y in cd/m^2 of a film without exposure
    std::vector<ChannelValues> noise;     ///< of these: half of what their samples' halves differ by; 0 of one sample
    std::vector<double> luminance_error;  ///< standard error of each pixel's Y by its samples taken for independent
};

/// Prepares `scene` for the pilot's channels: it is prepared for no model afterwards.
/// \throws std::invalid_argument as pilot_channels(), and for options out of their range.
[[nodiscard]] Pilot trace_pilot(PreparedScene& scene, std::span<const TransportModel> models,
                                const PilotOptions& options);

/// A pixel's spectrum over that of the scene's light, at whole nanometres: the same within each band. `light` as
/// node_integrals() has it; where it is 0, so is the ratio.
[[nodiscard]] std::vector<double> ratio_to_light(const PilotChannels& channels, const ChannelValues& pixel,
                                                 std::span<const double> light);

/// What a part of a pixel's channels is as a colour.
[[nodiscard]] XYZd xyz_of(const PilotChannels& channels, const PilotChannels::Part& part, const ChannelValues& pixel);

}  // namespace emulsion
