#include "display/blue_noise.h"

#include <cstddef>
#include <vector>

#include "display/threshold_rows.h"

namespace emulsion {

namespace {

/// The thresholds of every channel in turn; channel c begins c/3 of the size further right and further down.
std::vector<Threshold> tile_thresholds(int size, int channels) {
    const std::span<const std::uint16_t> ranks = blue_noise_ranks(size);
    const int mask = size - 1;  // the size is a power of two
    std::vector<Threshold> thresholds;
    thresholds.reserve(ranks.size() * static_cast<std::size_t>(channels));
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            for (int c = 0; c < channels; ++c) {
                const int shift = c * size / 3;
                const int from = ((y + shift) & mask) * size + ((x + shift) & mask);
                thresholds.push_back(threshold_of_rank(ranks[static_cast<std::size_t>(from)], size * size));
            }
        }
    }
    return thresholds;
}

}  // namespace

void quantize(const BlueNoise& dither, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    const std::vector<Threshold> tile = tile_thresholds(dither.size, source.channels());
    quantize_by_tile(tile, dither.size, source, scale, codes, threads);
}

}  // namespace emulsion
