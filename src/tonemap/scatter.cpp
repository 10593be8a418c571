#include "tonemap/scatter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "tonemap/blurred_light.h"

namespace emulsion {

namespace {

/// What a blur at this level has to add for sigma_px in all, in samples^2.
double variance_left(const LevelAxis& axis, double sigma_px) noexcept {
    return (sigma_px * sigma_px - axis.variance_px2) / (axis.scale_px * axis.scale_px);
}

/// Whether a blur here is wide enough for the samples, and the shape of their weights, not to show.
bool can_blur(const LevelAxis& axis, double sigma_px) noexcept {
    const bool is_whole_axis = axis.halving.size() == 1 && axis.scale_px == 1.0;
    return is_whole_axis || variance_left(axis, sigma_px) >= 3.0;
}

std::vector<float> weights_at(const LevelAxis& axis, double sigma_px) {
    if (axis.halving.size() == 1) return {1.0f};  // all of its mirror images are the sample itself
    return gaussian_weights(variance_left(axis, sigma_px));
}

struct Level {
    LevelAxis x, y;
    std::vector<GaussianBlur> blurs = {};

    [[nodiscard]] bool can_have(double sigma_px) const noexcept {
        return can_blur(x, sigma_px) && can_blur(y, sigma_px);
    }
};

/// The sum of exp(-k^2 / (2 sigma^2)) over all whole k.
double sum_of_gaussian(double sigma_px) noexcept {
    if (sigma_px > 2.0) return sigma_px * std::sqrt(2.0 * std::numbers::pi);
    double sum = 1.0;
    for (int k = 1; k <= 20; ++k) sum += 2.0 * std::exp(-0.5 * k * k / (sigma_px * sigma_px));
    return sum;
}

/// The levels that are needed, each lobe on the coarsest that can have it.
std::vector<Level> plan(std::span<const GaussianLobe> lobes, int width, int height) {
    std::vector<double> shares;
    double total = 0.0, widest_px = 0.0;
    for (const GaussianLobe& lobe : lobes) {
        shares.push_back(lobe.peak * std::pow(sum_of_gaussian(lobe.sigma_px), 2.0));
        total += shares.back();
        widest_px = std::max(widest_px, lobe.sigma_px);
    }
    std::vector<Level> levels{{LevelAxis(width), LevelAxis(height)}};
    while (levels.back().x.halving.size() > 1 || levels.back().y.halving.size() > 1) {
        Level next{levels.back().x.next(), levels.back().y.next()};
        if (!next.can_have(widest_px)) break;
        levels.push_back(std::move(next));
    }
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        const double sigma_px = lobes[i].sigma_px;
        std::size_t at = levels.size() - 1;
        while (at > 0 && !levels[at].can_have(sigma_px)) --at;
        levels[at].blurs.push_back({weights_at(levels[at].x, sigma_px), weights_at(levels[at].y, sigma_px),
                                    static_cast<float>(shares[i] / total)});
    }
    return levels;
}

/// What a level comes to with all coarser ones, of which `coarser` is the sum; null: there is none.
void sum_level(const Level& level, const LightRows& light, const Image<float>* coarser, int threads,
               const TakeRow& take) {
    constexpr int kRows = 32;  // in a block: the rows of its neighbours that it needs are worked out twice
    const std::size_t size = static_cast<std::size_t>(light.width) * static_cast<std::size_t>(light.channels);
    parallel_for(0, (light.height + kRows - 1) / kRows, threads, [&](int block) {
        const int y0 = block * kRows, y1 = std::min(light.height, y0 + kRows);
        std::vector<float> sum(size * static_cast<std::size_t>(y1 - y0));
        add_blurred(light, level.blurs, y0, y1, sum);
        for (int y = y0; y < y1; ++y) {
            const std::span<float> row = std::span(sum).subspan(static_cast<std::size_t>(y - y0) * size, size);
            if (coarser != nullptr) {
                add_doubled_row(*coarser, light.channels, level.x.halving, level.y.halving, y, row);
            }
            take(y, row);
        }
    });
}

}  // namespace

void scatter(std::span<const GaussianLobe> lobes, const LightRows& light, int threads, const TakeRow& take) {
    const std::vector<Level> levels = plan(lobes, light.width, light.height);

    // Down: the light at each coarser level.
    std::vector<Image<float>> lights;
    for (std::size_t at = 0; at + 1 < levels.size(); ++at) {
        const LightRows finer = at == 0 ? light : rows_of(lights.back(), light.channels);
        lights.push_back(halved(finer, levels[at].x.halving, levels[at].y.halving, threads));
    }

    // Up: the sums of all levels from the coarsest on.
    Image<float> coarser;
    for (std::size_t at = levels.size() - 1; at > 0; --at) {
        const Image<float>& here = lights[at - 1];
        Image<float> sum(here.width(), here.height());
        sum_level(levels[at], rows_of(here, light.channels), at + 1 < levels.size() ? &coarser : nullptr, threads,
                  [&](int y, std::span<const float> row) { std::copy(row.begin(), row.end(), sum.row(y).begin()); });
        coarser = std::move(sum);
        lights.pop_back();
    }
    sum_level(levels[0], light, levels.size() > 1 ? &coarser : nullptr, threads, take);
}

}  // namespace emulsion
