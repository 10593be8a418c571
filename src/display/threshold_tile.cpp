#include "display/threshold_tile.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

#include "core/row_blocks.h"

namespace emulsion {

namespace {

const ThresholdTile& tile_of(std::span<const ThresholdTile> tiles, std::size_t channel) noexcept {
    return tiles[std::min(channel, tiles.size() - 1)];
}

/// Pixels after which a row of all tiles together repeats, many enough for a loop over them to be worth it; never more
/// than the picture has.
std::size_t period(std::span<const ThresholdTile> tiles, int width) noexcept {
    constexpr std::int64_t kWorthALoop = 256;
    std::int64_t pixels = 1;
    for (const ThresholdTile& tile : tiles) pixels = std::lcm(pixels, std::int64_t{tile.width});
    pixels *= (kWorthALoop + pixels - 1) / pixels;
    return static_cast<std::size_t>(std::min<std::int64_t>(pixels, width));
}

/// The thresholds of row y as far as they don't repeat, component by component.
void fill_row(std::span<const ThresholdTile> tiles, int y, int channels, std::span<Threshold> row) noexcept {
    const auto step = static_cast<std::size_t>(channels);
    for (std::size_t c = 0; c < step; ++c) {
        const ThresholdTile& tile = tile_of(tiles, c);
        const auto width = static_cast<std::size_t>(tile.width);
        const std::size_t begin = static_cast<std::size_t>(y % tile.height) * width;
        std::size_t x = 0;
        for (std::size_t i = c; i < row.size(); i += step) {
            row[i] = tile.thresholds[begin + x];
            x = x + 1 == width ? 0 : x + 1;
        }
    }
}

}  // namespace

void round_by_thresholds(std::span<const float> encoded, std::span<const Threshold> thresholds, const CodeScale& scale,
                         std::span<std::uint16_t> codes) noexcept {
    const CodeUnits units(scale);
    const int fraction_bits = units.fraction_bits(), unused_bits = 16 - fraction_bits;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const int sum = units(encoded[i]) + (thresholds[i] >> unused_bits);
        codes[i] = static_cast<std::uint16_t>(scale.black + (sum >> fraction_bits));
    }
}

void quantize_by_tiles(std::span<const ThresholdTile> tiles, const EncodedRows& encoded, const CodeScale& scale,
                       const CodeRows& codes, int threads) {
    const std::size_t part = period(tiles, encoded.width) * static_cast<std::size_t>(encoded.channels);
    const RowBlocks blocks(encoded.width, encoded.height);
    parallel_for(0, blocks.count(), threads, [&](int block) {
        std::vector<Threshold> thresholds(part);
        for (int y = blocks.first_row(block); y < blocks.first_row(block + 1); ++y) {
            fill_row(tiles, y, encoded.channels, thresholds);
            const std::span<const float> in = encoded.row(y);
            const std::span<std::uint16_t> out = codes.row(y);
            for (std::size_t i = 0; i < in.size(); i += part) {
                const std::size_t count = std::min(part, in.size() - i);
                round_by_thresholds(in.subspan(i, count), std::span(thresholds).first(count), scale,
                                    out.subspan(i, count));
            }
        }
    });
}

}  // namespace emulsion
