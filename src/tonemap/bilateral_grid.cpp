#include "tonemap/bilateral_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/row_blocks.h"
#include "tonemap/bilateral_rows.h"
#include "tonemap/mirrored_border.h"
#include "tonemap/neighbourhood_rows.h"

namespace emulsion {

namespace {

/// One axis of the grid: where each pixel lies between its nodes. Nodes are mirrored at the picture's edges as pixels
/// are, half a step beyond the outer ones.
struct Axis {
    int nodes = 1;
    std::vector<int> before, after;  ///< of each pixel: the nodes about it
    std::vector<float> fraction;     ///< of each pixel: how far it lies from `before` towards `after`
    std::vector<float> kernel;       ///< the blur of the nodes
};

/// exp(-i^2 / (2 variance)) of i = 0 .. radius, scaled to a sum of 1 with negative i.
std::vector<float> sampled_gaussian(double variance, int radius) {
    std::vector<double> weights;
    double sum = 0.0;
    for (int i = 0; i <= radius; ++i) {
        weights.push_back(std::exp(-0.5 * i * i / variance));
        sum += i == 0 ? weights.back() : 2.0 * weights.back();
    }
    std::vector<float> kernel(weights.size());
    std::transform(weights.begin(), weights.end(), kernel.begin(),
                   [&](double weight) { return static_cast<float>(weight / sum); });
    return kernel;
}

Axis make_axis(int pixels, double sigma_px) {
    Axis axis;
    axis.nodes = std::max(1, static_cast<int>(pixels / std::max(1.0, 0.5 * sigma_px)));
    const double step_px = static_cast<double>(pixels) / axis.nodes;
    double blur = 0.0;  // variance of spreading and of reading
    for (int i = 0; i < pixels; ++i) {
        const double place = (i + 0.5) / step_px - 0.5, below = std::floor(place), fraction = place - below;
        axis.before.push_back(mirrored(static_cast<int>(below), axis.nodes));
        axis.after.push_back(mirrored(static_cast<int>(below) + 1, axis.nodes));
        axis.fraction.push_back(static_cast<float>(fraction));
        blur += 2.0 * fraction * (1.0 - fraction) / pixels;
    }
    const double sigma = sigma_px / step_px;
    axis.kernel = sampled_gaussian(std::max(sigma * sigma - blur, 1e-3), static_cast<int>(3.0 * sigma));
    return axis;
}

/// From the least positive luminance to the largest; 1 if there is none.
PositiveRange range_of(ImageView<const float> luminance, int threads) {
    std::vector<PositiveRange> rows(static_cast<std::size_t>(luminance.height()));
    parallel_for_rows(luminance.width(), luminance.height(), threads,
                      [&](int y) { rows[static_cast<std::size_t>(y)] = positive_range(luminance.row(y)); });
    PositiveRange range;
    for (const PositiveRange& row : rows) range = {std::min(range.least, row.least), std::max(range.most, row.most)};
    return range.most > 0.0f ? range : PositiveRange{1.0f, 1.0f};
}

GridLevels levels_of(const PositiveRange& range, double sigma_octaves) {
    std::array<float, 2> ends = {range.least, range.most};
    log2_row(range.least, ends);
    GridLevels levels{ends[0], static_cast<float>(0.5 * sigma_octaves), 2};
    levels.count += static_cast<std::uint32_t>((ends[1] - ends[0]) / levels.step);
    return levels;
}

/// Rows between the same two rows of nodes.
struct Band {
    int begin = 0, end = 0;
    std::vector<float> sums;  ///< what its pixels add to the two rows of nodes
};

class BilateralGrid {
  public:
    /// `luminance` becomes its logarithms.
    BilateralGrid(ImageView<float> luminance, double sigma_px, double sigma_octaves, int threads);

    void blur(int threads) {
        std::vector<float> blurred(sums_.size());
        parallel_for(0, down_.nodes, threads, [&](int y) { blur_row(y, blurred); });
        sums_.swap(blurred);
    }

    /// `logarithms` become averages of luminance.
    void read(ImageView<float> logarithms, int threads) const;

  private:
    [[nodiscard]] std::size_t node_size() const noexcept { return kGridSums * levels_.count; }
    [[nodiscard]] std::size_t cell_size() const noexcept { return kCellCopies * kCellSums * levels_.count; }
    [[nodiscard]] std::size_t row_size() const noexcept {
        return node_size() * static_cast<std::size_t>(across_.nodes);
    }
    [[nodiscard]] const float* row(int y) const noexcept {
        return sums_.data() + row_size() * static_cast<std::size_t>(y);
    }
    [[nodiscard]] GridColumns columns() const noexcept {
        return {cell_offset_.data(), left_.data(), right_.data(), shares_.data()};
    }

    void place_columns();
    void place_bands();
    void spread(ImageView<float> luminance, float least, Band& band) const;
    void gather(std::size_t cell, const float* sums, float* above, float* below) const noexcept;
    void blur_row(int y, std::vector<float>& blurred) const;

    Axis across_, down_;
    GridLevels levels_;
    std::vector<float> level_kernel_;
    std::vector<std::uint32_t> cell_offset_, left_, right_;  ///< GridColumns
    std::vector<float> shares_;
    std::vector<std::size_t> first_column_;  ///< of each cell of a row
    std::vector<Band> bands_;
    std::vector<float> sums_;
};

/// The levels are blurred by two steps, less what spreading and reading blur: twice the mean of f (1 - f) for f in
/// [0, 1].
BilateralGrid::BilateralGrid(ImageView<float> luminance, double sigma_px, double sigma_octaves, int threads)
    : across_(make_axis(luminance.width(), sigma_px)),
      down_(make_axis(luminance.height(), sigma_px)),
      level_kernel_(sampled_gaussian(4.0 - 1.0 / 3.0, 8)) {
    const PositiveRange range = range_of(luminance, threads);
    levels_ = levels_of(range, sigma_octaves);
    place_columns();
    place_bands();
    parallel_for(0, static_cast<int>(bands_.size()), threads,
                 [&](int band) { spread(luminance, range.least, bands_[static_cast<std::size_t>(band)]); });
    // In the order of bands, whichever was ready first.
    sums_.resize(row_size() * static_cast<std::size_t>(down_.nodes));
    parallel_for(0, down_.nodes, threads, [&](int node) {
        const std::span<float> to = std::span(sums_).subspan(row_size() * static_cast<std::size_t>(node), row_size());
        for (const Band& band : bands_) {
            const auto y = static_cast<std::size_t>(band.begin);
            const auto add = [&](const float* from) {
                std::transform(to.begin(), to.end(), from, to.begin(), std::plus());
            };
            if (down_.before[y] == node) add(band.sums.data());
            if (down_.after[y] == node) add(band.sums.data() + row_size());
        }
    });
    for (Band& band : bands_) band.sums = {};
}

void BilateralGrid::place_columns() {
    for (std::size_t x = 0; x < across_.fraction.size(); ++x) {
        const bool is_same =
            x > 0 && across_.before[x] == across_.before[x - 1] && across_.after[x] == across_.after[x - 1];
        if (!is_same) first_column_.push_back(x);
        const std::size_t cell = first_column_.size() - 1, copy = x % kCellCopies;
        cell_offset_.push_back(static_cast<std::uint32_t>(cell_size() * cell + kCellSums * levels_.count * copy));
        left_.push_back(static_cast<std::uint32_t>(node_size() * static_cast<std::size_t>(across_.before[x])));
        right_.push_back(static_cast<std::uint32_t>(node_size() * static_cast<std::size_t>(across_.after[x])));
        const float right = across_.fraction[x], left = 1.0f - right;
        shares_.insert(shares_.end(), {left, left, right, right});
    }
}

void BilateralGrid::place_bands() {
    const auto height = static_cast<int>(down_.fraction.size());
    for (int y = 0; y < height; ++y) {
        const auto here = static_cast<std::size_t>(y);
        const bool is_same =
            y > 0 && down_.before[here] == down_.before[here - 1] && down_.after[here] == down_.after[here - 1];
        if (is_same) {
            bands_.back().end = y + 1;
        } else {
            bands_.push_back({y, y + 1, {}});
        }
    }
}

void BilateralGrid::spread(ImageView<float> luminance, float least, Band& band) const {
    std::vector<float> cells(cell_size() * first_column_.size());
    for (int y = band.begin; y < band.end; ++y) {
        log2_row(least, luminance.row(y));
        spread_row(levels_, columns(), down_.fraction[static_cast<std::size_t>(y)], luminance.row(y), cells.data());
    }
    band.sums.resize(2 * row_size());
    for (std::size_t cell = 0; cell < first_column_.size(); ++cell) {
        gather(cell, cells.data() + cell_size() * cell, band.sums.data(), band.sums.data() + row_size());
    }
}

/// Adds a cell's sums to those of its nodes in the rows above and below.
void BilateralGrid::gather(std::size_t cell, const float* sums, float* above, float* below) const noexcept {
    const std::size_t left = left_[first_column_[cell]], right = right_[first_column_[cell]];
    for (std::size_t level = 0; level < levels_.count; ++level) {
        std::array<float, kCellSums> all{};
        for (std::size_t copy = 0; copy < kCellCopies; ++copy) {
            const float* const from = sums + kCellSums * (levels_.count * copy + level);
            for (std::size_t i = 0; i < kCellSums; ++i) all[i] += from[i];
        }
        for (std::size_t i = 0; i < kGridSums; ++i) {
            above[left + kGridSums * level + i] += all[i];
            above[right + kGridSums * level + i] += all[kGridSums + i];
            below[left + kGridSums * level + i] += all[2 * kGridSums + i];
            below[right + kGridSums * level + i] += all[3 * kGridSums + i];
        }
    }
}

void BilateralGrid::blur_row(int y, std::vector<float>& blurred) const {
    std::vector<float> column(row_size()), along(row_size());
    std::vector<const float*> taps;

    // From row to row
    const int down_radius = static_cast<int>(down_.kernel.size()) - 1;
    for (int j = -down_radius; j <= down_radius; ++j) taps.push_back(row(mirrored(y + j, down_.nodes)));
    convolve(down_.kernel, taps, column);

    // From node to node along the row
    const int across_radius = static_cast<int>(across_.kernel.size()) - 1;
    for (int x = 0; x < across_.nodes; ++x) {
        taps.clear();
        for (int j = -across_radius; j <= across_radius; ++j) {
            taps.push_back(column.data() + node_size() * static_cast<std::size_t>(mirrored(x + j, across_.nodes)));
        }
        convolve(across_.kernel, taps,
                 std::span(along).subspan(node_size() * static_cast<std::size_t>(x), node_size()));
    }

    // From level to level; there is nothing beyond the first and the last
    const std::size_t margin = kGridSums * (level_kernel_.size() - 1);
    std::vector<float> levels(node_size() + 2 * margin);
    float* const out = blurred.data() + row_size() * static_cast<std::size_t>(y);
    taps.clear();
    for (std::size_t j = 0; j <= 2 * (level_kernel_.size() - 1); ++j) taps.push_back(levels.data() + kGridSums * j);
    for (std::size_t x = 0; x < static_cast<std::size_t>(across_.nodes); ++x) {
        std::copy_n(along.data() + node_size() * x, node_size(), levels.data() + margin);
        convolve(level_kernel_, taps, {out + node_size() * x, node_size()});
    }
}

void BilateralGrid::read(ImageView<float> logarithms, int threads) const {
    parallel_for(0, static_cast<int>(bands_.size()), threads, [&](int number) {
        const Band& band = bands_[static_cast<std::size_t>(number)];
        std::vector<float> nodes(row_size());
        for (int y = band.begin; y < band.end; ++y) {
            const auto at = static_cast<std::size_t>(y);
            const float after = down_.fraction[at];
            add_rows(std::array{1.0f - after, after}, std::array{row(down_.before[at]), row(down_.after[at])}, nodes);
            read_row(levels_, columns(), nodes.data(), logarithms.row(y));
        }
    });
}

}  // namespace

void bilateral_filter(ImageView<float> luminance, double sigma_px, double sigma_octaves, int threads) {
    BilateralGrid grid(luminance, sigma_px, sigma_octaves, threads);
    grid.blur(threads);
    grid.read(luminance, threads);
}

}  // namespace emulsion
