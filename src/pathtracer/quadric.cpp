#include "pathtracer/quadric.h"

#include <algorithm>

namespace emulsion {

namespace {

using Imath::V3d;

double linear_determinant(const Imath::M44d& m) noexcept {
    return V3d(m[0][0], m[0][1], m[0][2]).dot(V3d(m[1][0], m[1][1], m[1][2]).cross(V3d(m[2][0], m[2][1], m[2][2])));
}

}  // namespace

QuadricPoint QuadricFrame::world_point(const V3d& position, const V3d& normal) const noexcept {
    QuadricPoint point;
    world_from_object.multVecMatrix(position, point.position);
    // Normals go by the inverse transpose.
    const auto& m = object_from_world.x;
    const V3d world_normal(m[0][0] * normal.x + m[0][1] * normal.y + m[0][2] * normal.z,
                           m[1][0] * normal.x + m[1][1] * normal.y + m[1][2] * normal.z,
                           m[2][0] * normal.x + m[2][1] * normal.y + m[2][2] * normal.z);
    point.area_stretch = std::abs(linear_determinant(world_from_object)) * world_normal.length();
    point.normal = (flip_normal ? -1.0 : 1.0) * world_normal.normalized();
    return point;
}

V3d tangent_at(const QuadricFrame& quadric, const V3d& position) noexcept {
    const V3d p = quadric.object_point(position);
    return quadric.world_vector({-p.y, p.x, 0.0});
}

Imath::Box3f bounds_of_cylinder(const Imath::M44d& world_from_object, double radius, double z, double z_top) noexcept {
    // Along world axis j a circle about z reaches as far as the length of the first two numbers of column j.
    const auto& m = world_from_object.x;
    Imath::Box3f box;
    for (int j = 0; j < 3; ++j) {
        const double reach = radius * std::sqrt(m[0][j] * m[0][j] + m[1][j] * m[1][j]);
        const double low = std::min(z * m[2][j], z_top * m[2][j]) + m[3][j] - reach;
        const double high = std::max(z * m[2][j], z_top * m[2][j]) + m[3][j] + reach;
        // Outward by more than the rounding to float.
        const double margin = 1e-6 * std::max(std::abs(low), std::abs(high));
        box.min[j] = static_cast<float>(low - margin);
        box.max[j] = static_cast<float>(high + margin);
    }
    return box;
}

}  // namespace emulsion
