#include "film/filter_gaussian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

double gaussian(double x, double sigma) noexcept {
    return std::exp(-x * x / (2.0 * sigma * sigma)) / (sigma * std::sqrt(2.0 * std::numbers::pi));
}

}  // namespace

double eval_inside(const GaussianFilter& filter, double offset_px, double radius_px) noexcept {
    const auto sigma_px = static_cast<double>(filter.sigma_px);
    return std::max(0.0, gaussian(offset_px, sigma_px) - gaussian(radius_px, sigma_px));
}

}  // namespace emulsion
