#include "tonemap/gaussian_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tonemap/convolve.h"
#include "tonemap/gaussian_kernel.h"
#include "tonemap/mirrored_border.h"

namespace emulsion {

GaussianRows::GaussianRows(ImageView<const float> source, std::span<const double> sigma_px, double tail)
    : source_(source) {
    const auto width = static_cast<std::size_t>(source.width());
    for (const double sigma : sigma_px) {
        const std::vector<double> kernel = gaussian_kernel(sigma, tail);
        Level level{{kernel.begin(), kernel.end()}, {}, std::vector<float>(width)};
        level.columns.resize(width + 2 * static_cast<std::size_t>(level.radius()));
        taps_.resize(std::max(taps_.size(), 2 * static_cast<std::size_t>(level.radius()) + 1));
        levels_.push_back(std::move(level));
    }
}

void GaussianRows::compute(int y) {
    // In parts so narrow that the rows of the source stay in the nearest cache for all levels.
    constexpr int kPart = 512;
    for (int x0 = 0; x0 < source_.width(); x0 += kPart) {
        for (Level& level : levels_) blur_columns(level, y, x0, std::min(source_.width(), x0 + kPart));
    }
    for (Level& level : levels_) blur_along(level);
}

void GaussianRows::blur_columns(Level& level, int y, int x0, int x1) {
    const int radius = level.radius();
    const float** const middle = taps_.data() + radius;
    for (int j = -radius; j <= radius; ++j) middle[j] = source_.row(mirrored(y + j, source_.height())).data() + x0;
    float* const first = level.columns.data() + radius;
    convolve(level.kernel, level.taps(taps_), {first + x0, first + x1});
}

void GaussianRows::blur_along(Level& level) {
    const int radius = level.radius(), width = source_.width();
    float* const first = level.columns.data() + radius;
    for (int j = 1; j <= radius; ++j) {
        first[-j] = first[mirrored(-j, width)];
        first[width - 1 + j] = first[mirrored(width - 1 + j, width)];
    }
    const float** const middle = taps_.data() + radius;
    for (int j = -radius; j <= radius; ++j) middle[j] = first + j;
    convolve(level.kernel, level.taps(taps_), level.blurred);
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
