#include "spectrum/color_context.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "core/named_value.h"
#include "spectrum/chromaticity.h"

namespace emulsion {

namespace {

const XYZd& checked_white(const XYZd& white) {
    constexpr double kTolerance = 1e-9;
    const auto [x, y, z] = white;
    const bool positive = std::isfinite(x) && std::isfinite(z) && x > 0.0 && z > 0.0;
    if (positive && std::abs(y - 1.0) <= kTolerance) return white;
    throw std::invalid_argument(fmt::format("white ({}, {}, {}): expected finite X, Z > 0 and Y = 1", x, y, z));
}

}  // namespace

ColorContext::ColorContext() : ColorContext(rgb_space("sRGB"), SrgbTransfer{}) {}

ColorContext::ColorContext(const RgbSpace& rgb, TransferFunction transfer)
    : ColorContext(rgb, std::move(transfer), xyz_of(rgb.white)) {}

ColorContext::ColorContext(const RgbSpace& rgb, TransferFunction transfer, const XYZd& white)
    : white_(checked_white(white)),
      rgb_(rgb),
      transfer_(std::move(transfer)),
      xyz_from_rgb_(emulsion::xyz_from_rgb(rgb)),
      rgb_from_xyz_(inverse(xyz_from_rgb_)) {
    validate_named(transfer_, "transfer");
}

RGBd ColorContext::linear_from_xyz(const XYZd& xyz) const noexcept {
    const auto [r, g, b] = rgb_from_xyz_ * std::array{xyz.x, xyz.y, xyz.z};
    return {r, g, b};
}

XYZd ColorContext::xyz_from_linear(const RGBd& linear) const noexcept {
    const auto [x, y, z] = xyz_from_rgb_ * std::array{linear.r, linear.g, linear.b};
    return {x, y, z};
}

RGBd ColorContext::encoded_from_xyz(const XYZd& xyz) const noexcept {
    const auto [r, g, b] = linear_from_xyz(xyz);
    return {encode(transfer_, r), encode(transfer_, g), encode(transfer_, b)};
}

XYZd ColorContext::xyz_from_encoded(const RGBd& encoded) const noexcept {
    const auto [r, g, b] = encoded;
    return xyz_from_linear({decode(transfer_, r), decode(transfer_, g), decode(transfer_, b)});
}

}  // namespace emulsion
