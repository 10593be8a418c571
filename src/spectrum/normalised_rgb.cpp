#include "spectrum/normalised_rgb.h"

namespace emulsion {

RGBd normalised_rgb_from_xyz(const XYZd& xyz) noexcept {
    static const Matrix3 rgb_from_xyz = inverse(kXyzFromNormalisedRgb);
    const auto [r, g, b] = rgb_from_xyz * std::array{xyz.x, xyz.y, xyz.z};
    return {r, g, b};
}

XYZd xyz_from_normalised_rgb(const RGBd& rgb) noexcept {
    const auto [x, y, z] = kXyzFromNormalisedRgb * std::array{rgb.r, rgb.g, rgb.b};
    return {x, y, z};
}

ColorValues from_xyz(const NormalisedRgbSystem& /*system*/, const XYZd& xyz, const ColorContext& /*context*/) noexcept {
    const RGBd rgb = normalised_rgb_from_xyz(xyz);
    return {{rgb.r, rgb.g, rgb.b}};
}

XYZd to_xyz(const NormalisedRgbSystem& /*system*/, const ColorValues& color, const ColorContext& /*context*/) noexcept {
    return xyz_from_normalised_rgb({color.value[0], color.value[1], color.value[2]});
}

}  // namespace emulsion
