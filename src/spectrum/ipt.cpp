#include "spectrum/ipt.h"

#include <cmath>

namespace emulsion {

namespace {

std::array<double, 3> odd_powers(std::array<double, 3> values, double exponent) noexcept {
    for (double& value : values) value = std::copysign(std::pow(std::abs(value), exponent), value);
    return values;
}

}  // namespace

Ipt ipt_from_xyz(const XYZd& xyz) noexcept {
    const std::array<double, 3> cones = kIptConesFromXyz * std::array{xyz.x, xyz.y, xyz.z};
    const auto [i, p, t] = kIptFromPowers * odd_powers(cones, kIptExponent);
    return {i, p, t};
}

XYZd xyz_from_ipt(const Ipt& ipt) noexcept {
    static const Matrix3 xyz_from_cones = inverse(kIptConesFromXyz), powers_from_ipt = inverse(kIptFromPowers);
    const std::array<double, 3> powers = powers_from_ipt * std::array{ipt.i, ipt.p, ipt.t};
    const auto [x, y, z] = xyz_from_cones * odd_powers(powers, 1.0 / kIptExponent);
    return {x, y, z};
}

ColorValues from_xyz(const IptSystem& /*system*/, const XYZd& xyz, const ColorContext& /*context*/) noexcept {
    const Ipt ipt = ipt_from_xyz(xyz);
    return {{ipt.i, ipt.p, ipt.t}};
}

XYZd to_xyz(const IptSystem& /*system*/, const ColorValues& color, const ColorContext& /*context*/) noexcept {
    return xyz_from_ipt({color.value[0], color.value[1], color.value[2]});
}

}  // namespace emulsion
