#pragma once
// Colours between spaces, and how far they are apart, as the tests of this folder ask.

#include <array>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/cielab.h"
#include "spectrum/color_difference.h"

namespace emulsion::stability {

inline double ciede2000(const XYZd& a, const XYZd& b, const XYZd& white) {
    return difference(Ciede2000Difference{}, lab_from_xyz(a, white), lab_from_xyz(b, white));
}
inline RGBd rgb_by(const Matrix3& m, const XYZd& xyz) {
    const auto [r, g, b] = m * std::array{xyz.x, xyz.y, xyz.z};
    return {r, g, b};
}
inline XYZd xyz_by(const Matrix3& m, const RGBd& rgb) {
    const auto [x, y, z] = m * std::array{rgb.r, rgb.g, rgb.b};
    return {x, y, z};
}

}  // namespace emulsion::stability
