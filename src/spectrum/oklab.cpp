#include "spectrum/oklab.h"

#include <cmath>

#include "spectrum/hue.h"

namespace emulsion {

Oklab oklab_from_xyz(const XYZd& xyz) noexcept {
    const auto [long_cones, medium_cones, short_cones] = kOklabConesFromXyz * std::array{xyz.x, xyz.y, xyz.z};
    const auto [l, a, b] =
        kOklabFromRoots * std::array{std::cbrt(long_cones), std::cbrt(medium_cones), std::cbrt(short_cones)};
    return {l, a, b};
}

XYZd xyz_from_oklab(const Oklab& oklab) noexcept {
    static const Matrix3 xyz_from_cones = inverse(kOklabConesFromXyz), roots_from_oklab = inverse(kOklabFromRoots);
    std::array<double, 3> cones = roots_from_oklab * std::array{oklab.l, oklab.a, oklab.b};
    for (double& response : cones) response *= response * response;
    const auto [x, y, z] = xyz_from_cones * cones;
    return {x, y, z};
}

Oklch oklch_from_oklab(const Oklab& oklab) noexcept {
    const auto [chroma, hue_deg] = chroma_hue_of({oklab.a, oklab.b});
    return {oklab.l, chroma, hue_deg};
}

Oklab oklab_from_oklch(const Oklch& oklch) noexcept {
    const auto [a, b] = chromatic_of({oklch.chroma, oklch.hue_deg});
    return {oklch.l, a, b};
}

ColorValues from_xyz(const OklabSystem& /*system*/, const XYZd& xyz, const ColorContext& /*context*/) noexcept {
    const Oklab oklab = oklab_from_xyz(xyz);
    return {{oklab.l, oklab.a, oklab.b}};
}

XYZd to_xyz(const OklabSystem& /*system*/, const ColorValues& color, const ColorContext& /*context*/) noexcept {
    return xyz_from_oklab({color.value[0], color.value[1], color.value[2]});
}

ColorValues from_xyz(const OklchSystem& /*system*/, const XYZd& xyz, const ColorContext& /*context*/) noexcept {
    const Oklch oklch = oklch_from_oklab(oklab_from_xyz(xyz));
    return {{oklch.l, oklch.chroma, oklch.hue_deg}};
}

XYZd to_xyz(const OklchSystem& /*system*/, const ColorValues& color, const ColorContext& /*context*/) noexcept {
    return xyz_from_oklab(oklab_from_oklch({color.value[0], color.value[1], color.value[2]}));
}

}  // namespace emulsion
