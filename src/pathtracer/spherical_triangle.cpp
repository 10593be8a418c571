#include "pathtracer/spherical_triangle.h"

#include <algorithm>
#include <cmath>

namespace emulsion {

namespace {

using Imath::V3d;

/// The unit vector at right angles to the unit vector `axis` in the plane that it spans with `v`.
V3d across(const V3d& v, const V3d& axis) noexcept { return (v - axis * v.dot(axis)).normalized(); }

}  // namespace

SphericalTriangle::SphericalTriangle(const V3d& p0, const V3d& p1, const V3d& p2) noexcept
    : a(p0.normalized()), b(p1.normalized()), c(p2.normalized()) {
    solid_angle = 2.0 * std::atan2(std::abs(a.dot(b.cross(c))), 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
}

bool is_seen_above(double tan_half, const V3d& p0, const V3d& p1, const V3d& p2) noexcept {
    const double l0 = std::sqrt(p0.dot(p0)), l1 = std::sqrt(p1.dot(p1)), l2 = std::sqrt(p2.dot(p2));
    const double denominator = l0 * l1 * l2 + p0.dot(p1) * l2 + p1.dot(p2) * l0 + p2.dot(p0) * l1;
    return std::abs(p0.dot(p1.cross(p2))) > tan_half * denominator;
}

V3d sample(const SphericalTriangle& triangle, std::array<double, 2> u) noexcept {
    const auto& [a, b, c, solid_angle] = triangle;
    // The angle at corner a, and the corner c' on the side from a to c that cuts off a share u[0] of the triangle.
    const V3d to_b = across(b, a), to_c = across(c, a);
    const double cos_alpha = std::clamp(to_b.dot(to_c), -1.0, 1.0), sin_alpha = to_b.cross(to_c).length();
    const double alpha = std::atan2(sin_alpha, cos_alpha);
    const double s = std::sin(u[0] * solid_angle - alpha), t = std::cos(u[0] * solid_angle - alpha);
    const double p = t - cos_alpha, q = s + sin_alpha * a.dot(b);
    const double denominator = (q * s + p * t) * sin_alpha;
    const double cosine = denominator == 0.0 ? 1.0 : ((q * t - p * s) * cos_alpha - q) / denominator;
    const double cut = std::clamp(cosine, -1.0, 1.0);
    const V3d c_cut = a * cut + to_c * std::sqrt(1.0 - cut * cut);

    // Along the arc from b to c', uniform in height over b.
    const double z = 1.0 - u[1] * (1.0 - std::min(1.0, c_cut.dot(b)));
    return b * z + across(c_cut, b) * std::sqrt(std::max(0.0, 1.0 - z * z));
}

}  // namespace emulsion
