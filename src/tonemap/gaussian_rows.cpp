#include "tonemap/gaussian_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tonemap/gaussian_kernel.h"
#include "tonemap/mirrored_border.h"
#include "tonemap/neighbourhood_rows.h"

namespace emulsion {

namespace {

std::vector<float> narrow_kernel(double sigma_px, double tail) {
    const std::vector<double> kernel = gaussian_kernel(sigma_px, tail);
    return {kernel.begin(), kernel.end()};
}

int radius_of(const std::vector<float>& kernel) noexcept { return static_cast<int>(kernel.size()) - 1; }

}  // namespace

GaussianRows::GaussianRows(int width, std::span<const GaussianSigma> sigmas, double tail) : width_(width) {
    const auto size = static_cast<std::size_t>(width);
    for (const GaussianSigma& sigma : sigmas) {
        Level level{narrow_kernel(sigma.x_px, tail), narrow_kernel(sigma.y_px, tail), {}, std::vector<float>(size)};
        level.columns.resize(size + 2 * (level.across.size() - 1));
        radius_ = std::max(radius_, radius_of(level.down));
        taps_.resize(std::max(taps_.size(), 2 * std::max(level.across.size(), level.down.size()) - 1));
        levels_.push_back(std::move(level));
    }
}

void GaussianRows::compute(std::span<const float* const> rows) {
    // In parts so narrow that the rows of the picture stay in the nearest cache for all levels.
    constexpr int kPart = 512;
    for (int x0 = 0; x0 < width_; x0 += kPart) {
        for (Level& level : levels_) blur_columns(level, rows, x0, std::min(width_, x0 + kPart));
    }
    for (Level& level : levels_) blur_along(level);
}

void GaussianRows::blur_columns(Level& level, std::span<const float* const> rows, int x0, int x1) {
    const std::size_t number = 2 * level.down.size() - 1;
    const auto used = rows.subspan(rows.size() / 2 - number / 2, number);
    std::transform(used.begin(), used.end(), taps_.begin(), [&](const float* row) { return row + x0; });
    float* const first = level.columns.data() + radius_of(level.across);
    convolve(level.down, std::span(taps_).first(number), {first + x0, first + x1});
}

void GaussianRows::blur_along(Level& level) {
    const int radius = radius_of(level.across);
    float* const first = level.columns.data() + radius;
    for (int j = 1; j <= radius; ++j) {
        first[-j] = first[mirrored(-j, width_)];
        first[width_ - 1 + j] = first[mirrored(width_ - 1 + j, width_)];
    }
    const std::size_t number = 2 * level.across.size() - 1;
    for (std::size_t j = 0; j < number; ++j) taps_[j] = level.columns.data() + j;
    convolve(level.across, std::span(taps_).first(number), level.blurred);
}

Image<double> gaussian_blur_reference(const Image<double>& source, double sigma_px) {
    const std::vector<double> kernel = gaussian_kernel(sigma_px, 1e-15);
    const int radius = static_cast<int>(kernel.size()) - 1, width = source.width(), height = source.height();
    const auto sum = [&](const auto& at) {
        double total = 0.0;
        for (int j = -radius; j <= radius; ++j) total += kernel[static_cast<std::size_t>(std::abs(j))] * at(j);
        return total;
    };
    Image<double> columns(width, height), blurred(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            columns(x, y) = sum([&](int j) { return source(x, mirrored(y + j, height)); });
        }
    }
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            blurred(x, y) = sum([&](int j) { return columns(mirrored(x + j, width), y); });
        }
    }
    return blurred;
}

}  // namespace emulsion
