#include "display/noise_dither.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
#include "core/row_blocks.h"
#include "display/threshold_rows.h"

namespace emulsion {

namespace {

/// Independent numbers that a component may need.
enum class Draw : std::uint64_t { first, second };

/// Uniform thresholds for a row, of components in turn: 16 bits for each channel from one hash of the pixel.
void fill_with_noise(Draw draw, int y, int channels, std::span<Threshold> row) noexcept {
    const std::uint64_t key = hash_combine(static_cast<std::uint64_t>(draw), static_cast<std::uint64_t>(y));
    std::uint64_t counter = key;
    const auto step = static_cast<std::size_t>(channels);
    for (std::size_t i = 0; i < row.size(); i += step) {
        counter += 0x9e3779b97f4a7c15u;  // the sequence of SplitMix64
        std::uint64_t bits = mix_bits(counter);
        for (std::size_t c = 0; c < step; ++c) {
            row[i + c] = static_cast<Threshold>(bits);
            bits >>= 16u;
        }
    }
}

/// With two uniform numbers of a code each. Their sum less a code is the triangular noise, and half a code more makes
/// rounding down one to nearest. The odd unit makes it symmetric about 0 but for half a unit.
void round_with_triangular(std::span<const float> encoded, std::span<const Threshold> first,
                           std::span<const Threshold> second, const CodeScale& scale,
                           std::span<std::uint16_t> codes) noexcept {
    const CodeUnits units(scale);
    const int fraction_bits = units.fraction_bits(), unused_bits = 16 - fraction_bits;
    const std::int32_t half = units.per_code() / 2, near_white = units.white() - half;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const std::int32_t value = units(encoded[i]);
        const std::int32_t rectangular = first[i] >> unused_bits;
        const std::int32_t triangular = rectangular + (second[i] >> unused_bits) + 1 - half;
        const bool near_end = value < half || value > near_white;
        const std::int32_t sum = value + (near_end ? rectangular : triangular);
        codes[i] = static_cast<std::uint16_t>(scale.black + (sum >> fraction_bits));
    }
}

}  // namespace

void quantize(const WhiteNoise& /*dither*/, const EncodedRows& encoded, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    const auto fill_row = [&](int y, std::span<Threshold> noise) {
        fill_with_noise(Draw::first, y, encoded.channels, noise);
    };
    quantize_by_thresholds(encoded, scale, codes, threads, encoded.width, fill_row);
}

void quantize(const TriangularNoise& /*dither*/, const EncodedRows& encoded, const CodeScale& scale,
              const CodeRows& codes, int threads) {
    const RowBlocks blocks(encoded.width, encoded.height);
    parallel_for(0, blocks.count(), threads, [&](int block) {
        std::vector<Threshold> first(encoded.row(0).size()), second(encoded.row(0).size());
        for (int y = blocks.first_row(block); y < blocks.first_row(block + 1); ++y) {
            fill_with_noise(Draw::first, y, encoded.channels, first);
            fill_with_noise(Draw::second, y, encoded.channels, second);
            round_with_triangular(encoded.row(y), first, second, scale, codes.row(y));
        }
    });
}

}  // namespace emulsion
