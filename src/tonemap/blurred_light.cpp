#include "tonemap/blurred_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tonemap/mirrored_border.h"

namespace emulsion {

namespace {

int radius_of(const std::vector<float>& weights) noexcept { return static_cast<int>(weights.size()) - 1; }

/// `padded` is the row with `radius` pixels more at each end.
void mirror_ends(std::span<float> padded, int width, int channels, int radius) noexcept {
    const auto at = [&](int x) { return padded.begin() + std::ptrdiff_t{radius + x} * channels; };
    for (int k = 0; k < radius; ++k) {
        std::copy_n(at(mirrored(-1 - k, width)), channels, at(-1 - k));
        std::copy_n(at(mirrored(width + k, width)), channels, at(width + k));
    }
}

/// out[i] = sum over k of weights[|k|] in[i + k step], `in` being the place of i = 0.
void sum_along(const std::vector<float>& weights, const float* in, std::ptrdiff_t step, std::size_t size,
               float* out) noexcept {
    for (std::size_t i = 0; i < size; ++i) out[i] = weights[0] * in[i];
    for (std::size_t k = 1; k < weights.size(); ++k) {
        const float weight = weights[k];
        const float* before = in - static_cast<std::ptrdiff_t>(k) * step;
        const float* after = in + static_cast<std::ptrdiff_t>(k) * step;
        for (std::size_t i = 0; i < size; ++i) out[i] += weight * (before[i] + after[i]);
    }
}

}  // namespace

std::vector<float> gaussian_weights(double variance_px2) {
    std::vector<double> exact{1.0};
    double sum = 1.0;
    for (int k = 1; k * k <= 16.0 * variance_px2; ++k) {
        exact.push_back(std::exp(-0.5 * k * k / variance_px2));
        sum += 2.0 * exact.back();
    }
    std::vector<float> weights(exact.size());
    double others = 0.0;
    for (std::size_t k = 1; k < exact.size(); ++k) {
        weights[k] = static_cast<float>(exact[k] / sum);
        others += 2.0 * double{weights[k]};
    }
    weights[0] = static_cast<float>(1.0 - others);
    return weights;
}

void add_blurred(const LightRows& light, std::span<const GaussianBlur> blurs, int y0, int y1, std::span<float> sum) {
    int reach_x = 0, reach_y = 0;
    for (const GaussianBlur& blur : blurs) {
        reach_x = std::max(reach_x, radius_of(blur.x));
        reach_y = std::max(reach_y, radius_of(blur.y));
    }

    // The rows and those that reach into them, each with what lies past its ends.
    const auto channels = static_cast<std::size_t>(light.channels);
    const std::size_t size = static_cast<std::size_t>(light.width) * channels;
    const std::size_t pad = static_cast<std::size_t>(reach_x) * channels, stride = size + 2 * pad;
    const auto rows = static_cast<std::size_t>(y1 - y0) + 2 * static_cast<std::size_t>(reach_y);
    std::vector<float> padded(rows * stride);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::span<float> here = std::span(padded).subspan(row * stride, stride);
        light.load(mirrored(y0 - reach_y + static_cast<int>(row), light.height), here.subspan(pad, size));
        mirror_ends(here, light.width, light.channels, reach_x);
    }

    std::vector<float> along_x(rows * size), blurred(size);
    for (const GaussianBlur& blur : blurs) {
        const auto reach = static_cast<std::size_t>(radius_of(blur.y)),
                   first = static_cast<std::size_t>(reach_y) - reach;
        for (std::size_t row = first; row < rows - first; ++row) {
            sum_along(blur.x, &padded[row * stride + pad], light.channels, size, &along_x[row * size]);
        }
        for (std::size_t row = 0; row < static_cast<std::size_t>(y1 - y0); ++row) {
            const float* centre = &along_x[(row + static_cast<std::size_t>(reach_y)) * size];
            sum_along(blur.y, centre, static_cast<std::ptrdiff_t>(size), size, blurred.data());
            for (std::size_t i = 0; i < size; ++i) sum[row * size + i] += blur.share * blurred[i];
        }
    }
}

}  // namespace emulsion
