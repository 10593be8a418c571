#include "spectrum/rgb_uplift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string_view>

#include <fmt/core.h>

#include "spectrum/data_table.h"
#include "spectrum/daylight.h"
#include "spectrum/sigmoid.h"

namespace emulsion {

namespace {

void require_components(const RGBd& rgb, double largest, std::string_view expected) {
    const auto require = [&](char name, double value) {
        if (std::isfinite(value) && value >= 0.0 && value <= largest) return;
        throw std::invalid_argument(fmt::format("RGB colour: {} = {}: expected {}", name, value, expected));
    };
    require('r', rgb.r);
    require('g', rgb.g);
    require('b', rgb.b);
}

}  // namespace

PiecewiseLinearSpectrum illuminant_of(const RgbSpace& space) {
    constexpr Chromaticity kD65 = {0.3127, 0.3290};
    constexpr double kTolerance = 5e-4;
    if (std::abs(space.white.x - kD65.x) <= kTolerance && std::abs(space.white.y - kD65.y) <= kTolerance) {
        return tabulated_spectrum("illuminants_a_d_300_830_5nm", "D65");
    }
    return daylight(space.white);
}

RgbUplift::RgbUplift(const RgbSpace& space)
    : illuminant_(illuminant_of(space)),
      weights_(reflectance_weights(illuminant_)),
      relative_xyz_from_rgb_(xyz_from_rgb(space)) {
    // Divided by the white, which takes in the small difference between its tabulated chromaticity and its spectrum.
    for (auto& row : relative_xyz_from_rgb_.m) {
        const double white = row[0] + row[1] + row[2];
        for (double& element : row) element /= white;
    }
    rgb_from_relative_xyz_ = inverse(relative_xyz_from_rgb_);
}

SigmoidSpectrum RgbUplift::reflectance(const RGBd& rgb) const {
    require_components(rgb, 1.0, "a number in [0, 1]");
    if (rgb.r == rgb.g && rgb.g == rgb.b) return {{0.0, 0.0, inverse_sigmoid(rgb.r)}};
    const std::array<double, 3> xyz = relative_xyz_from_rgb_ * std::array<double, 3>{rgb.r, rgb.g, rgb.b};
    return solve_sigmoid(weights_, {xyz[0], xyz[1], xyz[2]});
}

RgbIlluminantSpectrum RgbUplift::light(const RGBd& rgb) const {
    require_components(rgb, std::numeric_limits<double>::max(), "a finite number >= 0");
    const double largest = std::max({rgb.r, rgb.g, rgb.b});
    if (largest == 0.0) return {SigmoidSpectrum{}, illuminant_, 0.0};
    const double scale = 2.0 * largest;
    return {reflectance((1.0 / scale) * rgb), illuminant_, scale};
}

RGBd RgbUplift::rgb_of(const Spectrum& reflectance) const noexcept {
    const XYZd xyz = relative_xyz(weights_, reflectance);
    const std::array<double, 3> rgb = rgb_from_relative_xyz_ * std::array<double, 3>{xyz.x, xyz.y, xyz.z};
    return {rgb[0], rgb[1], rgb[2]};
}

SigmoidSpectrum fit_sigmoid(const RGBd& reflectance, const RgbSpace& space) {
    return RgbUplift(space).reflectance(reflectance);
}

RgbIlluminantSpectrum rgb_illuminant(const RGBd& light, const RgbSpace& space) { return RgbUplift(space).light(light); }

}  // namespace emulsion
