#pragma once
// Dithering by thresholds: a value becomes the code above it where its fraction reaches past the threshold of the
// pixel.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/row_blocks.h"
#include "display/code_units.h"
#include "display/component_rows.h"

namespace emulsion {

/// A fraction of a code in units of 2^-16. A value is rounded up if its fraction of a code and the threshold come to a
/// code or more, so that the mean of many pixels is that of their values where thresholds are evenly spread.
using Threshold = std::uint16_t;

/// The threshold of `rank` in [0, levels), in the middle of its part of a code; levels at most 2^16.
[[nodiscard]] constexpr Threshold threshold_of_rank(int rank, int levels) noexcept {
    return static_cast<Threshold>((2 * static_cast<std::uint32_t>(rank) + 1) * 32768 /
                                  static_cast<std::uint32_t>(levels));
}

/// codes[i] is encoded[i] in units and thresholds[i], rounded down. The three have one size.
void round_by_thresholds(std::span<const float> encoded, std::span<const Threshold> thresholds, const CodeScale& scale,
                         std::span<std::uint16_t> codes) noexcept;

/// As quantize() in display/dither.h, with thresholds that repeat after `period` pixels of a row.
/// fill_row(y, thresholds) writes those of row y, of the channels in turn, as far as they don't repeat; it must not
/// depend on anything else.
template <class FillRow>
void quantize_by_thresholds(const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes, int threads,
                            int period, const FillRow& fill_row) {
    const RowBlocks blocks(encoded.width, encoded.height);
    const auto channels = static_cast<std::size_t>(encoded.channels);
    const std::size_t part = static_cast<std::size_t>(std::min(period, encoded.width)) * channels;
    parallel_for(0, blocks.count(), threads, [&](int block) {
        std::vector<Threshold> thresholds(part);
        for (int y = blocks.first_row(block); y < blocks.first_row(block + 1); ++y) {
            fill_row(y, std::span(thresholds));
            const std::span<const float> in = encoded.row(y);
            for (std::size_t i = 0; i < in.size(); i += part) {
                const std::size_t count = std::min(part, in.size() - i);
                round_by_thresholds(in.subspan(i, count), std::span(thresholds).first(count), scale,
                                    codes.row(y).subspan(i, count));
            }
        }
    });
}

/// The same with the thresholds of a square tile, repeated: row by row, of each pixel as many as the picture has
/// channels. `size` is a power of two.
void quantize_by_tile(std::span<const Threshold> tile, int size, const EncodedRows& encoded, const CodeScale& scale,
                      const CodeRows& codes, int threads);

}  // namespace emulsion
