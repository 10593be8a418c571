#pragma once
// Dithering by thresholds: a value becomes the code above it where its fraction reaches past the threshold of the
// pixel.

#include <cstdint>
#include <span>
#include <vector>

#include "display/code_units.h"
#include "display/component_rows.h"

namespace emulsion {

/// One is one code: a threshold is a fraction of 2^16. A value is rounded up if its fraction of a code and the
/// threshold come to a code or more, so that the mean of many pixels is that of their values where thresholds are
/// evenly spread.
using Threshold = std::uint16_t;

/// The threshold of `rank` in [0, levels), in the middle of its part of a code; levels at most 2^16.
[[nodiscard]] constexpr Threshold threshold_of_rank(int rank, int levels) noexcept {
    return static_cast<Threshold>((2 * static_cast<std::int64_t>(rank) + 1) * 32768 / levels);
}

/// Thresholds to be repeated over the picture, row by row.
struct ThresholdTile {
    int width, height;  ///< in pixels, at least 1
    std::vector<Threshold> thresholds;
};

/// codes[i] is encoded[i] in units and thresholds[i], rounded down. The three have one size.
void round_by_thresholds(std::span<const float> encoded, std::span<const Threshold> thresholds, const CodeScale& scale,
                         std::span<std::uint16_t> codes) noexcept;

/// Channel c has the tile c of `tiles`; those past the last have the last one. As quantize() in display/dither.h.
void quantize_by_tiles(std::span<const ThresholdTile> tiles, const EncodedRows& encoded, const CodeScale& scale,
                       const CodeRows& codes, int threads);

}  // namespace emulsion
