#include "display/threshold_rows.h"

#include <algorithm>

namespace emulsion {

void quantize_by_tile(std::span<const Threshold> tile, int size, const EncodedSource& source, const CodeScale& scale,
                      const CodeRows& codes, int threads) {
    const std::size_t row = static_cast<std::size_t>(size) * static_cast<std::size_t>(source.channels());
    const auto fill_row = [&](int y, std::span<Threshold> thresholds) {
        const std::span<const Threshold> from = tile.subspan(static_cast<std::size_t>(y % size) * row, row);
        for (std::size_t i = 0; i < thresholds.size(); i += row) {
            const std::size_t count = std::min(row, thresholds.size() - i);
            std::ranges::copy(from.first(count), thresholds.subspan(i).begin());
        }
    };
    quantize_by_thresholds(source, scale, codes, threads, size, fill_row);
}

}  // namespace emulsion
