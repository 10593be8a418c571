#include "tonemap/axis_halving.h"

#include <algorithm>
#include <cstdint>

namespace emulsion {

namespace {

/// Taps come in rising order of `index`, or fall on one that is there.
void add(AxisHalving::Taps& taps, int index, double weight) noexcept {
    if (taps.count == 0) taps.first = index;
    const int at = index - taps.first;
    taps.weights[static_cast<std::size_t>(at)] += static_cast<float>(weight);
    taps.count = std::max(taps.count, at + 1);
}

}  // namespace

AxisHalving::AxisHalving(int size)
    : down_(static_cast<std::size_t>(size / 2 + size % 2)), up_(static_cast<std::size_t>(size)) {
    // In units of 1/m sample, all ends are whole: wider sample j is [j n, (j + 1) n), sample i is [i m, (i + 1) m).
    const std::int64_t n = size, m = half_size();
    for (int j = 0; j < half_size(); ++j) {
        std::array<std::int64_t, 5> overlaps{};  // of the samples from `first` on, smoothed; times 4
        const std::int64_t begin = j * n / m, end = ((j + 1) * n + m - 1) / m;
        const std::int64_t first = std::max<std::int64_t>(0, begin - 1);
        for (std::int64_t i = begin; i < end; ++i) {
            const std::int64_t overlap = std::min((i + 1) * m, (j + 1) * n) - std::max(i * m, j * n);
            overlaps[static_cast<std::size_t>(std::max<std::int64_t>(0, i - 1) - first)] += overlap;
            overlaps[static_cast<std::size_t>(i - first)] += 2 * overlap;
            overlaps[static_cast<std::size_t>(std::min(n - 1, i + 1) - first)] += overlap;
        }
        for (std::size_t k = 0; k < overlaps.size(); ++k) {
            if (overlaps[k] == 0) continue;
            const auto i = static_cast<int>(first) + static_cast<int>(k);
            const auto weight = 0.25 * static_cast<double>(overlaps[k]);
            add(down_[static_cast<std::size_t>(j)], i, weight / static_cast<double>(n));
            add(up_[static_cast<std::size_t>(i)], j, weight / static_cast<double>(m));
        }
    }
}

double AxisHalving::variance() const noexcept {
    if (size() == 1) return 0.0;
    return 2.0 * (0.5 + (spacing() * spacing() - 1.0) / 12.0);  // of [1 2 1] / 4, and of so many samples as one
}

LevelAxis LevelAxis::next() const {
    LevelAxis next(halving.half_size());
    next.scale_px = scale_px * halving.spacing();
    next.variance_px2 = variance_px2 + scale_px * scale_px * halving.variance();
    return next;
}

double LevelAxis::remaining_variance(double sigma_px) const noexcept {
    constexpr double kPixelVariance = 1.0 / 12.0;  // which gaussian_kernel() adds
    if (halving.size() == 1) return 0.0;
    return (sigma_px * sigma_px + kPixelVariance - variance_px2) / (scale_px * scale_px) - kPixelVariance;
}

}  // namespace emulsion
