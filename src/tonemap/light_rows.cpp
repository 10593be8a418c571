#include "tonemap/light_rows.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/row_blocks.h"

namespace emulsion {

namespace {

void add_scaled(std::span<const float> row, float weight, std::span<float> sum) noexcept {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * row[i];
}

/// The weighted mean of pixels of a row, each of Channels floats.
template <std::size_t Channels>
std::array<float, Channels> mean_of(const AxisHalving::Taps& taps, std::span<const float> row) noexcept {
    std::array<float, Channels> mean{};
    const float* pixel = &row[static_cast<std::size_t>(taps.first) * Channels];
    for (std::size_t k = 0; k < static_cast<std::size_t>(taps.count); ++k, pixel += Channels) {
        for (std::size_t c = 0; c < Channels; ++c) mean[c] += taps.weights[k] * pixel[c];
    }
    return mean;
}

template <std::size_t Channels>
void halve_row(const AxisHalving& axis, std::span<const float> row, std::span<float> half) noexcept {
    for (int j = 0; j < axis.half_size(); ++j) {
        const auto mean = mean_of<Channels>(axis.down(j), row);
        std::copy(mean.begin(), mean.end(), &half[static_cast<std::size_t>(j) * Channels]);
    }
}

template <std::size_t Channels>
void add_doubled(const AxisHalving& axis, std::span<const float> half, std::span<float> sum) noexcept {
    for (int i = 0; i < axis.size(); ++i) {
        const auto mean = mean_of<Channels>(axis.up(i), half);
        for (std::size_t c = 0; c < Channels; ++c) sum[static_cast<std::size_t>(i) * Channels + c] += mean[c];
    }
}

}  // namespace

LightRows rows_of(const Image<float>& image, int channels) {
    return {image.width() / channels, image.height(), channels, [&image](int y, std::span<float> row) {
                std::copy(image.row(y).begin(), image.row(y).end(), row.begin());
            }};
}

Image<float> halved(const LightRows& light, const AxisHalving& x, const AxisHalving& y, int threads) {
    Image<float> half(x.half_size() * light.channels, y.half_size());
    parallel_for_rows(light.width, y.half_size(), threads, [&](int j) {
        const std::size_t size = static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.channels);
        std::vector<float> row(size), sum(size);
        const AxisHalving::Taps& taps = y.down(j);
        for (int k = 0; k < taps.count; ++k) {
            light.load(taps.first + k, row);
            add_scaled(row, taps.weights[static_cast<std::size_t>(k)], sum);
        }
        light.channels == 3 ? halve_row<3>(x, sum, half.row(j)) : halve_row<1>(x, sum, half.row(j));
    });
    return half;
}

void add_doubled_row(const Image<float>& half, int channels, const AxisHalving& x, const AxisHalving& y, int row,
                     std::span<float> sum) {
    std::vector<float> mean(static_cast<std::size_t>(half.width()));
    const AxisHalving::Taps& taps = y.up(row);
    for (int k = 0; k < taps.count; ++k) {
        add_scaled(half.row(taps.first + k), taps.weights[static_cast<std::size_t>(k)], mean);
    }
    channels == 3 ? add_doubled<3>(x, mean, sum) : add_doubled<1>(x, mean, sum);
}

}  // namespace emulsion
