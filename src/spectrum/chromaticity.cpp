#include "spectrum/chromaticity.h"

#include <cmath>
#include <stdexcept>

#include <fmt/core.h>

namespace emulsion {

Chromaticity chromaticity_of(const XYZd& xyz) noexcept {
    const double sum = xyz.x + xyz.y + xyz.z;
    return {xyz.x / sum, xyz.y / sum};
}

XYZd xyz_of(const Chromaticity& chromaticity, double luminance) {
    const auto [x, y] = chromaticity;
    if (!std::isfinite(x) || !std::isfinite(y) || y == 0.0) {
        throw std::invalid_argument(
            fmt::format("chromaticity ({}, {}): expected finite numbers, y other than 0", x, y));
    }
    if (!std::isfinite(luminance)) {
        throw std::invalid_argument(fmt::format("luminance = {}: expected a finite number", luminance));
    }
    return {luminance * (x / y), luminance, luminance * ((1.0 - x - y) / y)};
}

Uv1976 uv_1976_of(const Chromaticity& chromaticity) noexcept {
    const auto [x, y] = chromaticity;
    const double denominator = -2.0 * x + 12.0 * y + 3.0;
    return {4.0 * x / denominator, 9.0 * y / denominator};
}

Chromaticity chromaticity_of(const Uv1976& uv) noexcept {
    const double denominator = 6.0 * uv.u - 16.0 * uv.v + 12.0;
    return {9.0 * uv.u / denominator, 4.0 * uv.v / denominator};
}

Uv1960 uv_1960_of(const Chromaticity& chromaticity) noexcept {
    const auto [x, y] = chromaticity;
    const double denominator = -2.0 * x + 12.0 * y + 3.0;
    return {4.0 * x / denominator, 6.0 * y / denominator};
}

Chromaticity chromaticity_of(const Uv1960& uv) noexcept {
    const double denominator = 2.0 * uv.u - 8.0 * uv.v + 4.0;
    return {3.0 * uv.u / denominator, 2.0 * uv.v / denominator};
}

Uv1976 uv_1976_of(const XYZd& xyz) noexcept {
    const double denominator = xyz.x + 15.0 * xyz.y + 3.0 * xyz.z;
    return {4.0 * xyz.x / denominator, 9.0 * xyz.y / denominator};
}

Uv1960 uv_1960_of(const XYZd& xyz) noexcept {
    const double denominator = xyz.x + 15.0 * xyz.y + 3.0 * xyz.z;
    return {4.0 * xyz.x / denominator, 6.0 * xyz.y / denominator};
}

}  // namespace emulsion
