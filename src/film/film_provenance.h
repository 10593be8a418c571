#pragma once
// Where the samples of a film come from: what two films must have in common to be added up, and a film and a renderer
// for the one to go on with the other.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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
    /// That every pixel of the film has; with stops_by_tile(), every pixel of tiles that have not stopped.
    SampleRanges samples = {};
    std::optional<PartialRound> partial = std::nullopt;  ///< beyond `samples`
    bool operator==(const FilmProvenance&) const = default;
};

/// What the sampling says where tiles of the picture stop on their own, each when it has enough samples; the target
/// follows. Such films don't add up by their ranges of samples, and how many a pixel has only the film knows.
inline constexpr std::string_view kStopsByTile = " until=";
[[nodiscard]] inline bool stops_by_tile(const FilmProvenance& provenance) noexcept {
    return provenance.sampling.find(kStopsByTile) != std::string::npos;
}

/// Samples taken of a pixel: every pixel has `least`, and none has more than `most`. Those that reach a pixel are
/// others where a filter splats them.
struct SamplesTaken {
    std::uint64_t least = 0, most = 0;
    bool operator==(const SamplesTaken&) const = default;
};

/// By the account, dropped samples among them; `most` is 0 if it knows of none, and with stops_by_tile().
[[nodiscard]] inline SamplesTaken samples_taken(const FilmProvenance& provenance) noexcept {
    if (stops_by_tile(provenance)) return {};
    const std::uint64_t least = provenance.samples.count();
    return {least, least + (provenance.partial ? provenance.partial->samples.size() : 0)};
}

}  // namespace emulsion
