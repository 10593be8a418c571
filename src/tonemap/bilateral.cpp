#include "tonemap/bilateral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "core/row_blocks.h"
#include "tonemap/bilateral_grid.h"
#include "tonemap/mirrored_border.h"

namespace emulsion {

namespace {

/// The least positive luminance; 1 if there is none.
template <class T>
T least_positive(const Image<T>& luminance, int threads) {
    constexpr T kNone = std::numeric_limits<T>::infinity();
    std::vector<T> rows(static_cast<std::size_t>(luminance.height()), kNone);
    parallel_for_rows(luminance.width(), luminance.height(), threads, [&](int y) {
        T least = kNone;
        for (const T value : luminance.row(y)) least = std::min(least, value > T(0) ? value : kNone);
        rows[static_cast<std::size_t>(y)] = least;
    });
    const T least = *std::min_element(rows.begin(), rows.end());
    return least < kNone ? least : T(1);
}

template <class T>
double sigma_px(const BilateralAdaptation& adaptation, const Image<T>& picture) noexcept {
    return double{adaptation.sigma_space} * std::max(picture.width(), picture.height());
}

}  // namespace

Image<float> local_luminance(const BilateralAdaptation& adaptation, const Image<float>& relative_luminance,
                             int threads) {
    const int width = relative_luminance.width(), height = relative_luminance.height();
    const float least = least_positive(relative_luminance, threads);
    Image<float> result(width, height);
    parallel_for_rows(width, height, threads, [&](int y) {
        const std::span<const float> in = relative_luminance.row(y);
        std::transform(in.begin(), in.end(), result.row(y).begin(),
                       [&](float luminance) { return std::log2(std::max(luminance, least)); });
    });
    const double octaves_in_decade = std::numbers::ln10 / std::numbers::ln2;
    bilateral_filter(result.view(), sigma_px(adaptation, result), octaves_in_decade * adaptation.sigma_range, threads);
    parallel_for_rows(width, height, threads, [&](int y) {
        for (float& value : result.row(y)) value = std::exp2(value);
    });
    return result;
}

Image<double> local_luminance_reference(const BilateralAdaptation& adaptation,
                                        const Image<double>& relative_luminance) {
    const int width = relative_luminance.width(), height = relative_luminance.height();
    const double least = least_positive(relative_luminance, 1), sigma = sigma_px(adaptation, relative_luminance);
    const int radius = static_cast<int>(3.0 * sigma);
    Image<double> logarithms(width, height), result(width, height);
    for (std::size_t i = 0; i < result.pixels().size(); ++i) {
        logarithms.pixels()[i] = std::log10(std::max(relative_luminance.pixels()[i], least));
    }
    const double for_space = -0.5 / (sigma * sigma), for_range = -0.5 / std::pow(double{adaptation.sigma_range}, 2.0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double here = logarithms(x, y);
            double sum = 0.0, weights = 0.0;
            for (int v = -radius; v <= radius; ++v) {
                for (int u = -radius; u <= radius; ++u) {
                    const double there = logarithms(mirrored(x + u, width), mirrored(y + v, height));
                    const double difference = there - here;
                    const double weight = std::exp(for_space * (u * u + v * v) + for_range * difference * difference);
                    sum += weight * difference;
                    weights += weight;
                }
            }
            result(x, y) = std::pow(10.0, here + sum / weights);
        }
    }
    return result;
}

}  // namespace emulsion
