#include "pathtracer/cylinder.h"

#include <algorithm>
#include <cmath>

namespace emulsion {

using Imath::V3d;

namespace {

QuadricPoint point_of(const PreparedCylinder& cylinder, double cos_phi, double sin_phi, double z) noexcept {
    return cylinder.world_point({cylinder.radius * cos_phi, cylinder.radius * sin_phi, z}, {cos_phi, sin_phi, 0.0});
}

}  // namespace

PreparedCylinder::PreparedCylinder(const Cylinder& cylinder)
    : QuadricFrame(cylinder.world_from_object, cylinder.flip_normal),
      radius(cylinder.radius),
      z_min(cylinder.z_min),
      z_max(cylinder.z_max),
      phi_max(cylinder.phi_max),
      object_area(radius * (z_max - z_min) * phi_max) {}

std::optional<double> first_hit(const PreparedCylinder& cylinder, const Imath::V3f& origin, const Imath::V3f& direction,
                                double t_min, double t_max) noexcept {
    const V3d o = cylinder.object_point(V3d(origin)), d = cylinder.object_vector(V3d(direction));

    // As for a sphere: from the point of the line that is closest to the axis, so that no digits cancel.
    const double a = d.x * d.x + d.y * d.y;
    if (!(a > 0.0)) return std::nullopt;
    const double t_closest = -(o.x * d.x + o.y * d.y) / a;
    const double x = o.x + t_closest * d.x, y = o.y + t_closest * d.y;
    const double squared = cylinder.radius * cylinder.radius - (x * x + y * y);
    if (squared < 0.0) return std::nullopt;
    const double half_chord = std::sqrt(squared / a);
    for (const double t : {t_closest - half_chord, t_closest + half_chord}) {
        if (!(t > t_min && t < t_max)) continue;
        const V3d p = o + t * d;
        if (p.z >= cylinder.z_min && p.z <= cylinder.z_max && angle_about_z(p) <= cylinder.phi_max) return t;
    }
    return std::nullopt;
}

QuadricPoint point_at(const PreparedCylinder& cylinder, const V3d& near_surface) noexcept {
    const V3d p = cylinder.object_point(near_surface);
    const double distance = std::hypot(p.x, p.y);
    return point_of(cylinder, p.x / distance, p.y / distance, p.z);
}

QuadricPoint sample_area(const PreparedCylinder& cylinder, std::array<float, 2> u) noexcept {
    const double z = cylinder.z_min + static_cast<double>(u[0]) * (cylinder.z_max - cylinder.z_min);
    const double phi = static_cast<double>(u[1]) * cylinder.phi_max;
    return point_of(cylinder, std::cos(phi), std::sin(phi), z);
}

Imath::Box3f bounds(const PreparedCylinder& cylinder) noexcept {
    return bounds_of_cylinder(cylinder.world_from_object, cylinder.radius, cylinder.z_min, cylinder.z_max);
}

Imath::V2f uv_at(const PreparedCylinder& cylinder, const V3d& position) noexcept {
    const V3d p = cylinder.object_point(position);
    return {static_cast<float>(angle_about_z(p) / cylinder.phi_max),
            static_cast<float>((p.z - cylinder.z_min) / (cylinder.z_max - cylinder.z_min))};
}

}  // namespace emulsion
