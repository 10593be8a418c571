#include "tonemap/half_size.h"

#include <array>
#include <cstddef>
#include <vector>

#include "core/row_blocks.h"
#include "tonemap/neighbourhood_rows.h"

namespace emulsion {

namespace {

/// The rows that `taps` are about, weighted.
void add_taps(const Image<float>& picture, const AxisHalving::Taps& taps, std::span<float> out) {
    const auto count = static_cast<std::size_t>(taps.count);
    std::array<const float*, std::tuple_size_v<decltype(taps.weights)>> rows{};
    for (std::size_t k = 0; k < count; ++k) rows[k] = picture.row(taps.first + static_cast<int>(k)).data();
    add_rows(std::span(taps.weights).first(count), std::span(rows).first(count), out);
}

float mean_of(const AxisHalving::Taps& taps, const float* row) noexcept {
    float mean = 0.0f;
    for (std::size_t k = 0; k < static_cast<std::size_t>(taps.count); ++k) {
        mean += taps.weights[k] * row[static_cast<std::size_t>(taps.first) + k];
    }
    return mean;
}

/// `padded` has one value before the row and one behind it, which are mirrored at the edges.
void mirror_ends(std::span<float> padded) noexcept {
    padded.front() = padded[1];
    padded.back() = padded[padded.size() - 2];
}

}  // namespace

Image<float> half_size(const Image<float>& picture, const AxisHalving& x, const AxisHalving& y, int threads) {
    Image<float> half(x.half_size(), y.half_size());
    parallel_for_rows(picture.width(), half.height(), threads, [&](int j) {
        std::vector<float> padded(static_cast<std::size_t>(x.size()) + 2);
        add_taps(picture, y.down(j), std::span(padded).subspan(1, padded.size() - 2));
        if (x.size() % 2 == 0) {
            mirror_ends(padded);
            halve_row(padded.data() + 1, half.row(j));
        } else {
            for (int i = 0; i < half.width(); ++i) half(i, j) = mean_of(x.down(i), padded.data() + 1);
        }
    });
    return half;
}

void double_size_row(const Image<float>& half, const AxisHalving& x, const AxisHalving& y, int row,
                     std::span<float> scratch, std::span<float> out) {
    const std::span<float> padded = scratch.first(static_cast<std::size_t>(half.width()) + 2);
    add_taps(half, y.up(row), padded.subspan(1, padded.size() - 2));
    if (x.size() % 2 == 0) {
        mirror_ends(padded);
        double_row(padded.data() + 1, out);
    } else {
        for (int i = 0; i < x.size(); ++i) out[static_cast<std::size_t>(i)] = mean_of(x.up(i), padded.data() + 1);
    }
}

}  // namespace emulsion
