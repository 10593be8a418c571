#include "display/noise_dither.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/random.h"
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

}  // namespace

void quantize(const WhiteNoise& /*dither*/, const EncodedSource& source, const CodeScale& scale, const CodeRows& codes,
              int threads) {
    const auto fill_row = [&](int y, std::span<Threshold> noise) {
        fill_with_noise(Draw::first, y, source.channels(), noise);
    };
    quantize_by_thresholds(source, scale, codes, threads, source.width(), fill_row);
}

void quantize(const TriangularNoise& /*dither*/, const EncodedSource& source, const CodeScale& scale,
              const CodeRows& codes, int threads) {
    const int channels = source.channels();
    const std::size_t row = codes.row(0).size();
    for_each_stretch(source, threads, [&, channels, row] {
        return [&, channels, first = std::vector<Threshold>(row), second = std::vector<Threshold>(row)](
                   int y, int x0, std::span<const float> encoded) mutable {
            if (x0 == 0) {
                fill_with_noise(Draw::first, y, channels, first);
                fill_with_noise(Draw::second, y, channels, second);
            }
            const auto part = [&](const auto& whole) {
                return std::span(whole).subspan(static_cast<std::size_t>(x0) * static_cast<std::size_t>(channels),
                                                encoded.size());
            };
            round_with_triangular_noise(encoded, part(first), part(second), scale, part(codes.row(y)));
        };
    });
}

}  // namespace emulsion
