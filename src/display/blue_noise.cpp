#include "display/blue_noise.h"

#include <cstddef>
#include <vector>

#include "display/threshold_tile.h"

namespace emulsion {

namespace {

/// The tile begun `shift` pixels further right and further down.
ThresholdTile shifted_tile(int size, int shift) {
    const std::span<const std::uint16_t> ranks = blue_noise_ranks(size);
    ThresholdTile tile{size, size, {}};
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int from = (y + shift) % size * size + (x + shift) % size;
            tile.thresholds.push_back(threshold_of_rank(ranks[static_cast<std::size_t>(from)], size * size));
        }
    }
    return tile;
}

}  // namespace

void quantize(const BlueNoise& dither, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    std::vector<ThresholdTile> tiles;
    for (int c = 0; c < encoded.channels; ++c) tiles.push_back(shifted_tile(dither.size, c * dither.size / 3));
    quantize_by_tiles(tiles, encoded, scale, codes, threads);
}

}  // namespace emulsion
