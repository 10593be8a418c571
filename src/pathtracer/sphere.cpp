#include "pathtracer/sphere.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

using Imath::V3d;

constexpr double kTurn = 2.0 * std::numbers::pi;

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

/// Whether a point of the whole sphere, in object space, is on the part that is there.
bool is_on_part(const PreparedSphere& sphere, const V3d& p) noexcept {
    return p.z >= sphere.z_min && p.z <= sphere.z_max && angle_about_z(p) <= sphere.phi_max;
}

}  // namespace

PreparedSphere::PreparedSphere(const Sphere& sphere)
    : QuadricFrame(sphere.world_from_object, sphere.flip_normal),
      radius(sphere.radius),
      z_min(std::max(sphere.z_min, -sphere.radius)),
      z_max(std::min(sphere.z_max, sphere.radius)),
      phi_max(sphere.phi_max),
      whole(z_min == -radius && z_max == radius && phi_max >= kTurn),
      object_area(radius * (z_max - z_min) * phi_max) {
    if (!whole) return;
    if (const auto scale = similarity_scale(world_from_object)) {
        world_centre = world_from_object.translation();
        world_radius = radius * *scale;
    }
}

std::optional<double> first_hit(const PreparedSphere& sphere, const Imath::V3f& origin, const Imath::V3f& direction,
                                double t_min, double t_max) noexcept {
    const V3d o = sphere.object_point(V3d(origin)), d = sphere.object_vector(V3d(direction));

    // Measured from the point of the line closest to the centre, the roots lie symmetrically, and no digits cancel.
    const double a = d.length2();
    if (!(a > 0.0)) return std::nullopt;
    const double t_closest = -o.dot(d) / a;
    const double squared = sphere.radius * sphere.radius - (o + t_closest * d).length2();
    if (squared < 0.0) return std::nullopt;
    const double half_chord = std::sqrt(squared / a);
    for (const double t : {t_closest - half_chord, t_closest + half_chord}) {
        if (t > t_min && t < t_max && (sphere.whole || is_on_part(sphere, o + t * d))) return t;
    }
    return std::nullopt;
}

QuadricPoint point_towards(const PreparedSphere& sphere, const V3d& direction) noexcept {
    const V3d outward = direction.normalized();
    return sphere.world_point(sphere.radius * outward, outward);
}

QuadricPoint point_at(const PreparedSphere& sphere, const V3d& near_surface) noexcept {
    return point_towards(sphere, sphere.object_point(near_surface));
}

QuadricPoint sample_area(const PreparedSphere& sphere, std::array<float, 2> u) noexcept {
    // Slices of one thickness have one area: Archimedes, "On the Sphere and Cylinder".
    const double z = (sphere.z_max + static_cast<double>(u[0]) * (sphere.z_min - sphere.z_max)) / sphere.radius;
    const double ring = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
    const double phi = static_cast<double>(u[1]) * sphere.phi_max;
    return point_towards(sphere, {ring * std::cos(phi), ring * std::sin(phi), z});
}

Imath::Box3f bounds(const PreparedSphere& sphere) noexcept {
    // Of a part, that of the whole: its rays are turned away one by one.
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

Imath::V2f uv_at(const PreparedSphere& sphere, const V3d& position) noexcept {
    const V3d p = sphere.object_point(position);
    const auto theta_of = [](double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)); };
    const double theta = theta_of(p.z / p.length());
    const double bottom = theta_of(sphere.z_min / sphere.radius), top = theta_of(sphere.z_max / sphere.radius);
    return {static_cast<float>(angle_about_z(p) / sphere.phi_max),
            static_cast<float>((theta - bottom) / (top - bottom))};
}

}  // namespace emulsion
