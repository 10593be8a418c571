#include "pathtracer/sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

using Imath::V3d;

/// M's linear part applied to a vector, in Imath's row-vector convention.
V3d transform_vector(const Imath::M44d& m, const V3d& v) noexcept {
    V3d out;
    m.multDirMatrix(v, out);
    return out;
}

/// n times the inverse transpose of world_from_object: a normal in world space, not normalised.
V3d transform_normal(const Imath::M44d& object_from_world, const V3d& n) noexcept {
    const auto& m = object_from_world.x;
    return {m[0][0] * n.x + m[0][1] * n.y + m[0][2] * n.z, m[1][0] * n.x + m[1][1] * n.y + m[1][2] * n.z,
            m[2][0] * n.x + m[2][1] * n.y + m[2][2] * n.z};
}

double linear_determinant(const Imath::M44d& m) noexcept {
    return V3d(m[0][0], m[0][1], m[0][2]).dot(V3d(m[1][0], m[1][1], m[1][2]).cross(V3d(m[2][0], m[2][1], m[2][2])));
}

/// The common length of the images of the axes if they are also at right angles: a similarity.
std::optional<double> similarity_scale(const Imath::M44d& m) noexcept {
    const V3d x(m[0][0], m[0][1], m[0][2]), y(m[1][0], m[1][1], m[1][2]), z(m[2][0], m[2][1], m[2][2]);
    const double scale2 = x.length2(), tolerance = 1e-9 * scale2;
    const bool same_length = std::abs(y.length2() - scale2) < tolerance && std::abs(z.length2() - scale2) < tolerance;
    const bool right_angles =
        std::abs(x.dot(y)) < tolerance && std::abs(y.dot(z)) < tolerance && std::abs(z.dot(x)) < tolerance;
    if (same_length && right_angles) return std::sqrt(scale2);
    return std::nullopt;
}

float largest_coordinate(const Imath::Box3f& box) noexcept {
    float largest = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max({largest, std::abs(box.min[axis]), std::abs(box.max[axis])});
    }
    return largest;
}

}  // namespace

PreparedSphere::PreparedSphere(const Sphere& sphere)
    : world_from_object(sphere.world_from_object),
      object_from_world(sphere.world_from_object.inverse(true)),
      radius(sphere.radius),
      flip_normal(sphere.flip_normal),
      extent(largest_coordinate(bounds(*this))) {
    if (const auto scale = similarity_scale(world_from_object)) {
        world_centre = world_from_object.translation();
        world_radius = radius * *scale;
        world_area = 4.0 * std::numbers::pi * world_radius * world_radius;
    }
}

std::optional<double> first_hit(const PreparedSphere& sphere, const Imath::V3f& origin, const Imath::V3f& direction,
                                double t_min, double t_max) noexcept {
    V3d o;
    sphere.object_from_world.multVecMatrix(V3d(origin), o);
    const V3d d = transform_vector(sphere.object_from_world, V3d(direction));

    // Measured from the point of the line closest to the centre, the roots lie symmetrically, and no digits cancel.
    const double a = d.length2();
    if (!(a > 0.0)) return std::nullopt;
    const double t_closest = -o.dot(d) / a;
    const double squared = sphere.radius * sphere.radius - (o + t_closest * d).length2();
    if (squared < 0.0) return std::nullopt;
    const double half_chord = std::sqrt(squared / a);
    for (const double t : {t_closest - half_chord, t_closest + half_chord}) {
        if (t > t_min && t < t_max) return t;
    }
    return std::nullopt;
}

SpherePoint point_towards(const PreparedSphere& sphere, const Imath::V3d& direction) noexcept {
    const V3d outward = direction.normalized();
    SpherePoint point;
    sphere.world_from_object.multVecMatrix(sphere.radius * outward, point.position);
    const V3d normal = transform_normal(sphere.object_from_world, outward);
    point.area_stretch = std::abs(linear_determinant(sphere.world_from_object)) * normal.length();
    point.normal = (sphere.flip_normal ? -1.0 : 1.0) * normal.normalized();
    return point;
}

SpherePoint point_at(const PreparedSphere& sphere, const Imath::V3d& near_surface) noexcept {
    V3d from_centre;
    sphere.object_from_world.multVecMatrix(near_surface, from_centre);
    return point_towards(sphere, from_centre);
}

Imath::Box3f bounds(const PreparedSphere& sphere) noexcept {
    // Along world axis j an ellipsoid reaches as far as the length of column j of the linear part.
    const auto& m = sphere.world_from_object.x;
    Imath::Box3f box;
    for (int j = 0; j < 3; ++j) {
        const double reach = sphere.radius * std::sqrt(m[0][j] * m[0][j] + m[1][j] * m[1][j] + m[2][j] * m[2][j]);
        // Outward by more than the rounding to float.
        const double margin = 1e-6 * (reach + std::abs(m[3][j]));
        box.min[j] = static_cast<float>(m[3][j] - reach - margin);
        box.max[j] = static_cast<float>(m[3][j] + reach + margin);
    }
    return box;
}

}  // namespace emulsion
