#include "tonemap/acuity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "core/row_blocks.h"
#include "tonemap/blurred_light.h"
#include "tonemap/mirrored_border.h"
#include "tonemap/pixel_class.h"
#include "tonemap/rod_vision.h"
#include "tonemap/spread_light.h"

namespace emulsion {

namespace {

constexpr double kFoveaSigma_degrees = 0.25;

double variance_px2(double adaptation_cdm2, const AcuityLoss& loss) noexcept {
    const double sigma_px = loss.weight * acuity_blur_degrees(adaptation_cdm2) / loss.degrees_per_px;
    return sigma_px * sigma_px;
}

/// The rows of Y alone.
LightRows luminances_of(const GoodLight& light, ImageView<const XYZ> scene) {
    return {scene.width(), scene.height(), 1, [scene, scale = light.scale](int y, std::span<float> row) {
                std::transform(scene.row(y).begin(), scene.row(y).end(), row.begin(), [&](const XYZ& pixel) {
                    return is_bad(classify(pixel)) ? 0.0f : static_cast<float>(scale * pixel.y);
                });
            }};
}

Image<float> spread(const LightRows& light, double sigma_px, int threads) {
    Image<float> result(light.width, light.height);
    const GaussianLobe lobe{.sigma_px = sigma_px};
    scatter({&lobe, 1}, light, threads,
            [&](int y, std::span<const float> row) { std::copy(row.begin(), row.end(), result.row(y).begin()); });
    return result;
}

/// What good pixels are adapted to, in cd/m^2.
Image<float> foveal_luminance(const GoodLight& light, ImageView<const XYZ> scene, double sigma_px, int threads) {
    Image<float> mean = spread(luminances_of(light, scene), sigma_px, threads);
    const Image<float> good = light.has_bad ? spread(light.good, sigma_px, threads) : Image<float>();
    parallel_for_rows(scene.width(), scene.height(), threads, [&](int y) {
        for (int x = 0; x < scene.width(); ++x) {
            const double lost = light.has_bad ? std::max(0.0, 1.0 - double{good(x, y)}) : 0.0;
            mean(x, y) = static_cast<float>(mean(x, y) / light.scale + lost * scene(x, y).y);
        }
    });
    return mean;
}

/// Where a pixel lies between the samples of a level.
struct Between {
    std::size_t before = 0, after = 0;
    float weight = 0.0f;  ///< of `after`
};

Between between(int px, const LevelAxis& axis) noexcept {
    const int size = axis.halving.size();
    const double at = std::clamp((px + 0.5) / axis.scale_px - 0.5, 0.0, size - 1.0);
    const int before = std::min(static_cast<int>(at), std::max(0, size - 2));
    return {static_cast<std::size_t>(before), static_cast<std::size_t>(std::min(before + 1, size - 1)),
            static_cast<float>(at - before)};
}

/// A level of the pyramid: sums of good light, and how much of it is good.
struct AcuityLevel {
    LevelAxis x, y;
    double variance_px2 = 0.0;  ///< of a pixel taken from here
    Image<float> light = {};    ///< empty at the level of the picture itself
    Image<float> good = {};     ///< empty if all is good
};

using Sum = std::array<float, 4>;  // X, Y, Z, good

/// Linear interpolation; adds it times `weight`.
void add_level(const AcuityLevel& level, int px, int py, float weight, Sum& sum) noexcept {
    const Between x = between(px, level.x), y = between(py, level.y);
    for (const auto& [row, row_weight] : {std::pair{y.before, 1.0f - y.weight}, {y.after, y.weight}}) {
        for (const auto& [column, column_weight] : {std::pair{x.before, 1.0f - x.weight}, {x.after, x.weight}}) {
            const float here = weight * row_weight * column_weight;
            const std::span<const float> light = level.light.row(static_cast<int>(row));
            for (std::size_t c = 0; c < 3; ++c) sum[c] += here * light[3 * column + c];
            sum[3] +=
                level.good.width() == 0 ? here : here * level.good(static_cast<int>(column), static_cast<int>(row));
        }
    }
}

/// Levels until one is blurred by at least `most_px2`, or there is nothing left to halve.
std::vector<AcuityLevel> pyramid(const GoodLight& light, double most_px2, int threads) {
    std::vector<AcuityLevel> levels{{LevelAxis(light.rows.width), LevelAxis(light.rows.height)}};
    while (levels.back().variance_px2 < most_px2) {
        const AcuityLevel& finer = levels.back();
        if (finer.x.halving.size() == 1 && finer.y.halving.size() == 1) break;
        const bool first = levels.size() == 1;
        AcuityLevel next{finer.x.next(), finer.y.next()};
        next.light = halved(first ? light.rows : rows_of(finer.light, 3), finer.x.halving, finer.y.halving, threads);
        if (light.has_bad) {
            next.good = halved(first ? light.good : rows_of(finer.good, 1), finer.x.halving, finer.y.halving, threads);
        }
        // Half of coming here and going back, and linear interpolation, a sixth of the spacing's square on average.
        const LevelAxis& longer = next.x.scale_px > next.y.scale_px ? next.x : next.y;
        next.variance_px2 = 0.5 * longer.variance_px2 + longer.scale_px * longer.scale_px / 6.0;
        levels.push_back(std::move(next));
    }
    return levels;
}

/// The mean about a good pixel, times the light's scale.
Sum blurred(const std::vector<AcuityLevel>& levels, const XYZ& pixel, double scale, int px, int py, double wanted_px2) {
    std::size_t coarser = 1;
    while (coarser + 1 < levels.size() && levels[coarser].variance_px2 < wanted_px2) ++coarser;
    const double finer_px2 = levels[coarser - 1].variance_px2, coarser_px2 = levels[coarser].variance_px2;
    const auto share = static_cast<float>(std::min(1.0, (wanted_px2 - finer_px2) / (coarser_px2 - finer_px2)));
    Sum sum{};
    add_level(levels[coarser], px, py, share, sum);
    if (coarser > 1) {
        add_level(levels[coarser - 1], px, py, 1.0f - share, sum);
    } else {
        const double here = scale * (1.0 - double{share});  // may be beyond floats, of pixels that are denormal
        sum[0] += static_cast<float>(here * pixel.x);
        sum[1] += static_cast<float>(here * pixel.y);
        sum[2] += static_cast<float>(here * pixel.z);
        sum[3] += 1.0f - share;
    }
    return sum;
}

}  // namespace

double highest_visible_frequency(double adaptation_cdm2) noexcept {
    return 17.25 * std::atan(1.4 * std::log10(std::max(adaptation_cdm2, 1e-5)) + 0.35) + 25.72;
}

double acuity_blur_degrees(double adaptation_cdm2) noexcept {
    if (adaptation_cdm2 >= kMostMesopic_cdm2) return 0.0;
    // The contrast that a Gaussian leaves is exp(-2 (pi sigma frequency)^2).
    const double sigma_times_frequency = std::sqrt(0.5 * std::log(20.0)) / std::numbers::pi;
    const double least = 1.0 / highest_visible_frequency(kMostMesopic_cdm2);
    const double here = 1.0 / highest_visible_frequency(adaptation_cdm2);
    return sigma_times_frequency * std::sqrt(std::max(0.0, here * here - least * least));
}

void lose_acuity(ImageView<XYZ> picture, const AcuityLoss& loss, int threads) {
    const GoodLight light = good_light(picture, threads);
    const std::vector<AcuityLevel> levels = pyramid(light, variance_px2(0.0, loss), threads);
    if (levels.size() == 1) return;
    const Image<float> adaptation =
        foveal_luminance(light, picture, kFoveaSigma_degrees / loss.degrees_per_px, threads);
    parallel_for_rows(picture.width(), picture.height(), threads, [&](int y) {
        for (int x = 0; x < picture.width(); ++x) {
            XYZ& pixel = picture(x, y);
            const double wanted_px2 = variance_px2(double{adaptation(x, y)}, loss);
            if (wanted_px2 == 0.0 || is_bad(classify(pixel))) continue;
            const Sum sum = blurred(levels, pixel, light.scale, x, y, wanted_px2);
            const double unit = 1.0 / (light.scale * double{sum[3]});
            pixel = {static_cast<float>(unit * sum[0]), static_cast<float>(unit * sum[1]),
                     static_cast<float>(unit * sum[2])};
        }
    });
}

Image<XYZd> lose_acuity_reference(const Image<XYZd>& picture, ImageView<const XYZ> scene, const AcuityLoss& loss) {
    const auto mean = [&](int px, int py, double sigma_px, bool keep_what_is_lost) {
        const int reach = static_cast<int>(std::ceil(5.0 * sigma_px));
        XYZd sum;
        double weights = 0.0;
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                int from_x = mirrored(px + x, scene.width()), from_y = mirrored(py + y, scene.height());
                if (is_bad(classify(scene(from_x, from_y)))) {
                    if (!keep_what_is_lost) continue;
                    from_x = px;
                    from_y = py;
                }
                const double weight = std::exp(-0.5 * (x * x + y * y) / (sigma_px * sigma_px));
                sum = sum + weight * picture(from_x, from_y);
                weights += weight;
            }
        }
        return 1.0 / weights * sum;
    };
    Image<XYZd> result = picture;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (is_bad(classify(scene(x, y)))) continue;
            const double adaptation = mean(x, y, kFoveaSigma_degrees / loss.degrees_per_px, true).y;
            const double wanted_px2 = variance_px2(adaptation, loss);
            if (wanted_px2 > 0.0) result(x, y) = mean(x, y, std::sqrt(wanted_px2), false);
        }
    }
    return result;
}

}  // namespace emulsion
