#include "tonemap/bilateral.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "tonemap/bilateral_grid.h"
#include "tonemap/mirrored_border.h"

namespace emulsion {

namespace {

/// The least positive luminance; 1 if there is none.
double least_positive(const Image<double>& luminance) {
    double least = std::numeric_limits<double>::infinity();
    for (const double value : luminance.pixels()) {
        if (value > 0.0) least = std::min(least, value);
    }
    return std::isfinite(least) ? least : 1.0;
}

template <class T>
double sigma_px(const BilateralAdaptation& adaptation, const Image<T>& picture) noexcept {
    return double{adaptation.sigma_space} * std::max(picture.width(), picture.height());
}

}  // namespace

Image<float> local_luminance(const BilateralAdaptation& adaptation, Image<float> relative_luminance, int threads) {
    const double octaves_in_decade = std::numbers::ln10 / std::numbers::ln2;
    const double sigma = sigma_px(adaptation, relative_luminance);
    bilateral_filter(relative_luminance.view(), sigma, octaves_in_decade * adaptation.sigma_range, threads);
    return relative_luminance;
}

Image<double> local_luminance_reference(const BilateralAdaptation& adaptation,
                                        const Image<double>& relative_luminance) {
    const int width = relative_luminance.width(), height = relative_luminance.height();
    const double least = least_positive(relative_luminance), sigma = sigma_px(adaptation, relative_luminance);
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
