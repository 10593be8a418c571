#include "pathtracer/texel_distribution.h"

#include <algorithm>
#include <span>

namespace emulsion {

namespace {

/// Cumulative shares of `weights` into `shares`, which has one more. Returns the sum of the weights.
template <class Weight>
double accumulate_shares(std::span<const Weight> weights, float* shares) {
    double total = 0.0;
    for (const Weight weight : weights) total += static_cast<double>(weight);
    double sum = 0.0;
    shares[0] = 0.0f;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += static_cast<double>(weights[i]);
        const double even = static_cast<double>(i + 1) / static_cast<double>(weights.size());
        shares[i + 1] = static_cast<float>(total > 0.0 ? std::min(sum / total, 1.0) : even);
    }
    shares[weights.size()] = 1.0f;
    return total;
}

struct Cell {
    int index;
    float offset;  // in [0, 1)
};

/// The cell of the cumulative shares that u falls into, which is never an empty one.
Cell find_cell(const float* shares, int count, float u) noexcept {
    const float* const above = std::upper_bound(shares + 1, shares + count, u);
    const float end = *above, begin = *(above - 1);
    constexpr float kBelowOne = 0x1.fffffep-1f;
    return {static_cast<int>(above - shares) - 1, std::clamp((u - begin) / (end - begin), 0.0f, kBelowOne)};
}

}  // namespace

TexelDistribution::TexelDistribution(const Image<float>& weights)
    : width_(weights.width()),
      height_(weights.height()),
      rows_(static_cast<std::size_t>(height_) + 1),
      columns_(static_cast<std::size_t>(height_) * (static_cast<std::size_t>(width_) + 1)) {
    std::vector<double> row_weights;
    for (int y = 0; y < height_; ++y) {
        float* const shares = columns_.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_ + 1);
        row_weights.push_back(accumulate_shares(weights.row(y), shares));
    }
    accumulate_shares(std::span<const double>(row_weights), rows_.data());
}

Imath::V2d TexelDistribution::sample(std::array<float, 2> u) const noexcept {
    const Cell row = find_cell(rows_.data(), height_, u[1]);
    const Cell column = find_cell(columns_of(row.index), width_, u[0]);
    const auto place = [](const Cell& cell, int count) {
        return (static_cast<double>(cell.index) + static_cast<double>(cell.offset)) / static_cast<double>(count);
    };
    return {place(column, width_), place(row, height_)};
}

float TexelDistribution::density(int x, int y) const noexcept {
    const float row = rows_[static_cast<std::size_t>(y) + 1] - rows_[static_cast<std::size_t>(y)];
    const float* const columns = columns_of(y);
    return row * (columns[x + 1] - columns[x]) * static_cast<float>(width_) * static_cast<float>(height_);
}

}  // namespace emulsion
