#include "tonemap/global_adaptation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/row_blocks.h"

namespace emulsion {

namespace {

struct WeightedSum {
    double sum = 0.0, weight = 0.0;
};

/// The sum over all pixels of add(row's sum, x, y, pixel), row by row.
template <class Add>
WeightedSum sum_of_pixels(ImageView<const XYZ> scene, int threads, const Add& add) {
    std::vector<WeightedSum> rows(static_cast<std::size_t>(scene.height()));
    parallel_for_rows(scene.width(), scene.height(), threads, [&](int y) {
        WeightedSum& row = rows[static_cast<std::size_t>(y)];
        for (int x = 0; x < scene.width(); ++x) add(row, x, y, scene(x, y));
    });
    WeightedSum total;
    for (const WeightedSum& row : rows) {
        total.sum += row.sum;
        total.weight += row.weight;
    }
    return total;
}

/// The log-average of the positive pixels with weight(x, y), without outliers; of all alike where none has any.
template <class Weight>
double weighted_log_average(ImageView<const XYZ> scene, const SceneLuminance& luminance, int threads,
                            const Weight& weight) {
    const WeightedSum total = sum_of_pixels(scene, threads, [&](WeightedSum& row, int x, int y, const XYZ& pixel) {
        if (classify(pixel) != PixelClass::positive) return;
        if (pixel.y >= luminance.least_outlier_cdm2() || pixel.y <= luminance.most_dark_outlier_cdm2()) return;
        const double here = weight(x, y);
        if (here == 0.0) return;
        row.sum += here * std::log(double{pixel.y});
        row.weight += here;
    });
    return total.weight > 0.0 ? std::exp(total.sum / total.weight) : luminance.log_average_cdm2();
}

double shorter_side(ImageView<const XYZ> scene) noexcept { return std::min(scene.width(), scene.height()); }

}  // namespace

double adaptation_cdm2(const LogAverageAdaptation&, ImageView<const XYZ>, const SceneLuminance& luminance, int) {
    return luminance.log_average_cdm2();
}

double adaptation_cdm2(const AverageAdaptation&, ImageView<const XYZ> scene, const SceneLuminance& luminance,
                       int threads) {
    const double least_outlier = luminance.least_outlier_cdm2();
    const WeightedSum total = sum_of_pixels(scene, threads, [&](WeightedSum& row, int, int, const XYZ& pixel) {
        const PixelClass pixel_class = classify(pixel);
        if (pixel_class != PixelClass::positive && pixel_class != PixelClass::zero) return;
        if (pixel.y >= least_outlier) return;
        row.sum += pixel.y;
        row.weight += 1.0;
    });
    return total.sum / total.weight;
}

double adaptation_cdm2(const MedianAdaptation&, ImageView<const XYZ>, const SceneLuminance& luminance, int) {
    return luminance.quantile_cdm2(0.5);
}

double adaptation_cdm2(const CentreWeightedAdaptation& adaptation, ImageView<const XYZ> scene,
                       const SceneLuminance& luminance, int threads) {
    const double centre_x = 0.5 * (scene.width() - 1), centre_y = 0.5 * (scene.height() - 1);
    const double sigma = double{adaptation.sigma} * shorter_side(scene);
    return weighted_log_average(scene, luminance, threads, [&](int x, int y) {
        const double dx = (x - centre_x) / sigma, dy = (y - centre_y) / sigma;
        return std::exp(-0.5 * (dx * dx + dy * dy));
    });
}

double adaptation_cdm2(const SpotAdaptation& adaptation, ImageView<const XYZ> scene, const SceneLuminance& luminance,
                       int threads) {
    // Positions in pixels, the centre of pixel (0, 0) at (0.5, 0.5).
    const double centre_x = double{adaptation.x} * scene.width(), centre_y = double{adaptation.y} * scene.height();
    const int pixel_x = std::min(static_cast<int>(centre_x), scene.width() - 1);
    const int pixel_y = std::min(static_cast<int>(centre_y), scene.height() - 1);
    const double radius = double{adaptation.radius} * shorter_side(scene);
    return weighted_log_average(scene, luminance, threads, [&](int x, int y) {
        const bool inside = std::hypot(x + 0.5 - centre_x, y + 0.5 - centre_y) <= radius;
        return inside || (x == pixel_x && y == pixel_y) ? 1.0 : 0.0;
    });
}

}  // namespace emulsion
