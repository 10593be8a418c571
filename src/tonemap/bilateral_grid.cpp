#include "tonemap/bilateral_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "core/row_blocks.h"
#include "tonemap/convolve.h"
#include "tonemap/mirrored_border.h"

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

/// The least and the largest value.
std::pair<float, float> range_of(ImageView<const float> values, int threads) {
    std::vector<std::pair<float, float>> rows(static_cast<std::size_t>(values.height()));
    parallel_for_rows(values.width(), values.height(), threads, [&](int y) {
        float least = values(0, y), most = least;
        for (const float value : values.row(y)) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
        rows[static_cast<std::size_t>(y)] = {least, most};
    });
    std::pair<float, float> range = rows.front();
    for (const auto& [least, most] : rows) range = {std::min(range.first, least), std::max(range.second, most)};
    return range;
}

/// What a node holds: a sum of weights, and one of weighted values, the values in steps of the grid.
constexpr std::size_t kSums = 2;

class BilateralGrid {
  public:
    BilateralGrid(ImageView<const float> values, double sigma_px, double sigma_value, int threads)
        : BilateralGrid(values, range_of(values, threads), sigma_px, sigma_value) {
        spread(values, threads);
    }

    void blur(int threads) {
        std::vector<float> blurred(sums_.size());
        parallel_for(0, down_.nodes, threads, [&](int y) { blur_row(y, blurred); });
        sums_.swap(blurred);
    }

    void read_row(int y, std::span<float> values) const noexcept;

  private:
    /// Empty. The levels are blurred by two steps, less what spreading and reading blur: twice the mean of f (1 - f)
    /// for f in [0, 1].
    BilateralGrid(ImageView<const float> values, std::pair<float, float> range, double sigma_px, double sigma_value)
        : across_(make_axis(values.width(), sigma_px)),
          down_(make_axis(values.height(), sigma_px)),
          least_(range.first),
          step_(static_cast<float>(0.5 * sigma_value)),
          levels_(static_cast<std::size_t>((range.second - range.first) / step_) + 2),
          level_kernel_(sampled_gaussian(4.0 - 1.0 / 3.0, 8)) {}

    [[nodiscard]] std::size_t node_size() const noexcept { return kSums * levels_; }
    [[nodiscard]] std::size_t row_size() const noexcept {
        return node_size() * static_cast<std::size_t>(across_.nodes);
    }
    [[nodiscard]] const float* row(int y) const noexcept {
        return sums_.data() + row_size() * static_cast<std::size_t>(y);
    }

    void spread(ImageView<const float> values, int threads);
    void spread_row(std::span<const float> values, float down, float* before, float* after) const noexcept;
    void blur_row(int y, std::vector<float>& blurred) const;

    Axis across_, down_;
    float least_, step_;  ///< the value of the first level, and from one to the next
    std::size_t levels_;
    std::vector<float> level_kernel_;
    std::vector<float> sums_;
};

/// Rows between the same two rows of nodes are spread by one thread into sums of their own, which are then added in a
/// fixed order.
void BilateralGrid::spread(ImageView<const float> values, int threads) {
    std::vector<int> first_row = {0};
    for (int y = 1; y < values.height(); ++y) {
        const auto here = static_cast<std::size_t>(y);
        const bool same = down_.before[here] == down_.before[here - 1] && down_.after[here] == down_.after[here - 1];
        if (!same) first_row.push_back(y);
    }
    const int bands = static_cast<int>(first_row.size());
    first_row.push_back(values.height());
    std::vector<std::vector<float>> sums(static_cast<std::size_t>(bands));
    parallel_for(0, bands, threads, [&](int number) {
        const auto band = static_cast<std::size_t>(number);
        sums[band].resize(2 * row_size());
        for (int y = first_row[band]; y < first_row[band + 1]; ++y) {
            float* const before = sums[band].data();
            spread_row(values.row(y), down_.fraction[static_cast<std::size_t>(y)], before, before + row_size());
        }
    });
    sums_.resize(row_size() * static_cast<std::size_t>(down_.nodes));
    for (std::size_t band = 0; band < sums.size(); ++band) {
        const auto y = static_cast<std::size_t>(first_row[band]);
        const auto add = [&](int node, std::size_t begin) {
            float* const to = sums_.data() + row_size() * static_cast<std::size_t>(node);
            for (std::size_t i = 0; i < row_size(); ++i) to[i] += sums[band][begin + i];
        };
        add(down_.before[y], 0);
        add(down_.after[y], row_size());
    }
}

void BilateralGrid::spread_row(std::span<const float> values, float down, float* before, float* after) const noexcept {
    for (std::size_t x = 0; x < values.size(); ++x) {
        const float value = (values[x] - least_) / step_;
        const auto level = static_cast<std::size_t>(value);
        const float up = value - static_cast<float>(level), across = across_.fraction[x];
        const std::array<float, 2 * kSums> sums = {1.0f - up, (1.0f - up) * value, up, up * value};
        const std::size_t left = static_cast<std::size_t>(across_.before[x]) * node_size() + kSums * level;
        const std::size_t right = static_cast<std::size_t>(across_.after[x]) * node_size() + kSums * level;
        const auto add = [&](float* to, float weight) {
            for (std::size_t i = 0; i < sums.size(); ++i) to[i] += weight * sums[i];
        };
        add(before + left, (1.0f - down) * (1.0f - across));
        add(before + right, (1.0f - down) * across);
        add(after + left, down * (1.0f - across));
        add(after + right, down * across);
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
    const std::size_t margin = kSums * (level_kernel_.size() - 1);
    std::vector<float> levels(node_size() + 2 * margin);
    float* const out = blurred.data() + row_size() * static_cast<std::size_t>(y);
    taps.clear();
    for (std::size_t j = 0; j <= 2 * (level_kernel_.size() - 1); ++j) taps.push_back(levels.data() + kSums * j);
    for (std::size_t x = 0; x < static_cast<std::size_t>(across_.nodes); ++x) {
        std::copy_n(along.data() + node_size() * x, node_size(), levels.data() + margin);
        convolve(level_kernel_, taps, {out + node_size() * x, node_size()});
    }
}

void BilateralGrid::read_row(int y, std::span<float> values) const noexcept {
    const auto at = static_cast<std::size_t>(y);
    const float *const before = row(down_.before[at]), *const after = row(down_.after[at]);
    const float down = down_.fraction[at];
    for (std::size_t x = 0; x < values.size(); ++x) {
        const float value = (values[x] - least_) / step_;
        const auto level = static_cast<std::size_t>(value);
        const float up = value - static_cast<float>(level), across = across_.fraction[x];
        const std::size_t left = static_cast<std::size_t>(across_.before[x]) * node_size() + kSums * level;
        const std::size_t right = static_cast<std::size_t>(across_.after[x]) * node_size() + kSums * level;
        std::array<float, 2 * kSums> sums{};
        for (std::size_t i = 0; i < sums.size(); ++i) {
            sums[i] = (1.0f - down) * ((1.0f - across) * before[left + i] + across * before[right + i]) +
                      down * ((1.0f - across) * after[left + i] + across * after[right + i]);
        }
        const float weight = (1.0f - up) * sums[0] + up * sums[2], sum = (1.0f - up) * sums[1] + up * sums[3];
        values[x] = least_ + step_ * (sum / weight);
    }
}

}  // namespace

void bilateral_filter(ImageView<float> values, double sigma_px, double sigma_value, int threads) {
    BilateralGrid grid(values, sigma_px, sigma_value, threads);
    grid.blur(threads);
    parallel_for_rows(values.width(), values.height(), threads, [&](int y) { grid.read_row(y, values.row(y)); });
}

}  // namespace emulsion
