#pragma once
// Dithering by thresholds: a value becomes the code above it where its fraction reaches past the threshold of the
// pixel.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "display/code_rows.h"
#include "display/component_rows.h"
#include "display/encoded_source.h"

namespace emulsion {

/// The threshold of `rank` in [0, levels), in the middle of its part of a code; levels at most 2^16.
[[nodiscard]] constexpr Threshold threshold_of_rank(int rank, int levels) noexcept {
    return static_cast<Threshold>((2 * static_cast<std::uint32_t>(rank) + 1) * 32768 /
                                  static_cast<std::uint32_t>(levels));
}

/// As quantize() in display/dither.h, with thresholds that repeat after `period` pixels of a row: the width or more, or
/// a divisor of kStretch_px. fill_row(y, thresholds) writes those of row y, of the channels in turn, as far as they
/// don't repeat or a stretch goes; it must not depend on anything else.
template <class FillRow>
void quantize_by_thresholds(const EncodedSource& source, const CodeScale& scale, const CodeRows& codes, int threads,
                            int period, const FillRow& fill_row) {
    const auto channels = static_cast<std::size_t>(source.channels());
    const bool repeats = period < source.width();
    const int kept = repeats ? kStretch_px : source.width();
    for_each_stretch(source, threads, [&, channels, repeats, kept] {
        return [&, channels, repeats, row = std::vector<Threshold>(static_cast<std::size_t>(kept) * channels)](
                   int y, int x0, std::span<const float> encoded) mutable {
            if (x0 == 0) fill_row(y, std::span(row));
            const std::size_t begin = static_cast<std::size_t>(x0) * channels;
            const std::span<const Threshold> thresholds = std::span(row).subspan(repeats ? 0 : begin, encoded.size());
            round_by_thresholds(encoded, thresholds, scale, codes.row(y).subspan(begin, encoded.size()));
        };
    });
}

/// The same with the thresholds of a square tile, repeated: row by row, of each pixel as many as the picture has
/// channels. `size` is a power of two, up to kStretch_px.
void quantize_by_tile(std::span<const Threshold> tile, int size, const EncodedSource& source, const CodeScale& scale,
                      const CodeRows& codes, int threads);

}  // namespace emulsion
