#include "spectrum/cielab.h"

#include <cmath>

namespace emulsion {

namespace {

// Cube root above (6/29)^3, and below it the straight line that continues it with the same slope.
double lab_f(double ratio) noexcept {
    constexpr double kKnee = 6.0 / 29.0;
    if (ratio > kKnee * kKnee * kKnee) return std::cbrt(ratio);
    return ratio / (3.0 * kKnee * kKnee) + 4.0 / 29.0;
}

}  // namespace

Lab lab_from_xyz(const XYZd& xyz, const XYZd& white) noexcept {
    const double fx = lab_f(xyz.x / white.x), fy = lab_f(xyz.y / white.y), fz = lab_f(xyz.z / white.z);
    return {116.0 * fy - 16.0, 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

}  // namespace emulsion
