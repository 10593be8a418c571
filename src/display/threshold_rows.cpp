#include "display/threshold_rows.h"

namespace emulsion {

void round_by_thresholds(std::span<const float> encoded, std::span<const Threshold> thresholds, const CodeScale& scale,
                         std::span<std::uint16_t> codes) noexcept {
    const CodeUnits units(scale);
    const int fraction_bits = units.fraction_bits(), unused_bits = 16 - fraction_bits;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        const int sum = units(encoded[i]) + (thresholds[i] >> unused_bits);
        codes[i] = static_cast<std::uint16_t>(scale.black + (sum >> fraction_bits));
    }
}

void quantize_by_tile(std::span<const Threshold> tile, int size, const EncodedRows& encoded, const CodeScale& scale,
                      const CodeRows& codes, int threads) {
    constexpr int kWorthALoop_px = 1024;
    const std::size_t row = static_cast<std::size_t>(size) * static_cast<std::size_t>(encoded.channels);
    const auto fill_row = [&](int y, std::span<Threshold> thresholds) {
        const std::span<const Threshold> from = tile.subspan(static_cast<std::size_t>(y % size) * row, row);
        for (std::size_t i = 0; i < thresholds.size(); i += row) {
            const std::size_t count = std::min(row, thresholds.size() - i);
            std::ranges::copy(from.first(count), thresholds.subspan(i).begin());
        }
    };
    quantize_by_thresholds(encoded, scale, codes, threads, kWorthALoop_px, fill_row);
}

}  // namespace emulsion
