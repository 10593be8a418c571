#pragma once
// Where the samples of a film come from: what two films must have in common to be added up, and a film and a renderer
// for the one to go on with the other.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "film/sample_ranges.h"

namespace emulsion {

/// A round of samples that a renderer has finished in some of its tiles only.
struct PartialRound {
    SampleRange samples;             ///< of the tiles that are done
    int tile_px = 0;                 ///< the side of a tile; tiles are counted row by row over the film's sample bounds
    std::vector<std::uint8_t> done;  ///< of each tile: 1 or 0
    bool operator==(const PartialRound&) const = default;
};

struct FilmProvenance {
    /// Of all that is rendered: a hash of the scene, or whatever else tells scenes apart. Empty: unknown, and equal to
    /// nothing but itself.
    std::string scene = {};
    /// Of all that decides the samples of an index: sampler, seed, wavelengths, renderer and its version.
    std::string sampling = {};
    SampleRanges samples = {};                           ///< that every pixel of the film has
    std::optional<PartialRound> partial = std::nullopt;  ///< beyond `samples`
    bool operator==(const FilmProvenance&) const = default;
};

}  // namespace emulsion
