#include "tonemap/gaussian_blur.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/row_blocks.h"
#include "tonemap/axis_halving.h"
#include "tonemap/change_rows.h"
#include "tonemap/gaussian_rows.h"
#include "tonemap/half_size.h"

namespace emulsion {

namespace {

Image<float> blur_directly(Image<float> picture, const GaussianSigma& sigma, int threads) {
    constexpr double kTail = 1e-4;  // bright lights spread as far as they are seen
    const int width = picture.width(), radius = GaussianRows(1, std::array{sigma}, kTail).radius();
    change_rows(picture, radius, threads, [&] {
        return [&picture, blurred = GaussianRows(width, std::array{sigma}, kTail)](
                   int y, std::span<const float* const> rows) mutable {
            blurred.compute(rows);
            std::copy(blurred.row(0).begin(), blurred.row(0).end(), picture.row(y).begin());
        };
    });
    return picture;
}

void double_size(const Image<float>& half, const AxisHalving& x, const AxisHalving& y, Image<float>& whole,
                 int threads) {
    parallel_for_rows(whole.width(), whole.height(), threads, [&](int row) {
        std::vector<float> scratch(static_cast<std::size_t>(half.width()) + 2);
        double_size_row(half, x, y, row, scratch, whole.row(row));
    });
}

/// Whether there is enough left to blur at a level for what going there and back looks like not to show.
bool fits(const LevelAxis& axis, double sigma_px) noexcept {
    return axis.halving.size() == 1 || axis.remaining_variance(sigma_px) >= 1.0;
}

Image<float> blur_at(const LevelAxis& x, const LevelAxis& y, Image<float> picture, double sigma_px, int threads) {
    const LevelAxis half_x = x.next(), half_y = y.next();
    const bool is_dot = picture.pixels().size() == 1;
    if (is_dot || !fits(half_x, sigma_px) || !fits(half_y, sigma_px)) {
        const auto sigma = [&](const LevelAxis& axis) { return std::sqrt(axis.remaining_variance(sigma_px)); };
        return blur_directly(std::move(picture), {sigma(x), sigma(y)}, threads);
    }
    const Image<float> half =
        blur_at(half_x, half_y, half_size(picture, x.halving, y.halving, threads), sigma_px, threads);
    double_size(half, x.halving, y.halving, picture, threads);
    return picture;
}

}  // namespace

Image<float> gaussian_blur(Image<float> picture, double sigma_px, int threads) {
    const LevelAxis x(picture.width()), y(picture.height());
    return blur_at(x, y, std::move(picture), sigma_px, threads);
}

}  // namespace emulsion
