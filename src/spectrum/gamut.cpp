#include "spectrum/gamut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "spectrum/chromaticity_polygon.h"

namespace emulsion {

RgbGamut::RgbGamut(const RgbSpace& space)
    : triangle_(convex_hull(std::array<Chromaticity, 3>{space.red, space.green, space.blue})),
      rgb_from_xyz_(rgb_from_xyz(space)) {}

double RgbGamut::signed_distance(const Chromaticity& chromaticity) const noexcept {
    return emulsion::signed_distance(triangle_, chromaticity);
}

double RgbGamut::margin(const XYZd& xyz) const noexcept {
    const std::array<double, 3> rgb = rgb_from_xyz_ * std::array<double, 3>{xyz.x, xyz.y, xyz.z};
    return gamut_margin({rgb[0], rgb[1], rgb[2]});
}

double gamut_margin(const RGBd& rgb) noexcept {
    // std::min would lose a NaN that comes second.
    if (std::isnan(rgb.r) || std::isnan(rgb.g) || std::isnan(rgb.b)) return std::numeric_limits<double>::quiet_NaN();
    return std::min({rgb.r, rgb.g, rgb.b, 1.0 - rgb.r, 1.0 - rgb.g, 1.0 - rgb.b});
}

}  // namespace emulsion
