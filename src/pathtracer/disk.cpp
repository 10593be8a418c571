#include "pathtracer/disk.h"

#include <cmath>

namespace emulsion {

using Imath::V3d;

PreparedDisk::PreparedDisk(const Disk& disk)
    : QuadricFrame(disk.world_from_object, disk.flip_normal),
      height(disk.height),
      radius(disk.radius),
      inner_radius(disk.inner_radius),
      phi_max(disk.phi_max),
      object_area(0.5 * phi_max * (radius - inner_radius) * (radius + inner_radius)) {}

std::optional<double> first_hit(const PreparedDisk& disk, const Imath::V3f& origin, const Imath::V3f& direction,
                                double t_min, double t_max) noexcept {
    const V3d o = disk.object_point(V3d(origin)), d = disk.object_vector(V3d(direction));
    const double t = (disk.height - o.z) / d.z;  // no number, or infinite, along the plane
    if (!(t > t_min && t < t_max)) return std::nullopt;
    const V3d p = o + t * d;
    const double radius2 = p.x * p.x + p.y * p.y;
    if (radius2 > disk.radius * disk.radius || radius2 < disk.inner_radius * disk.inner_radius) return std::nullopt;
    if (angle_about_z(p) > disk.phi_max) return std::nullopt;
    return t;
}

QuadricPoint point_at(const PreparedDisk& disk, const V3d& near_surface) noexcept {
    const V3d p = disk.object_point(near_surface);
    return disk.world_point({p.x, p.y, disk.height}, {0.0, 0.0, 1.0});
}

QuadricPoint sample_area(const PreparedDisk& disk, std::array<float, 2> u) noexcept {
    const double inner2 = disk.inner_radius * disk.inner_radius, outer2 = disk.radius * disk.radius;
    const double r = std::sqrt(inner2 + static_cast<double>(u[0]) * (outer2 - inner2));
    const double phi = static_cast<double>(u[1]) * disk.phi_max;
    return disk.world_point({r * std::cos(phi), r * std::sin(phi), disk.height}, {0.0, 0.0, 1.0});
}

Imath::Box3f bounds(const PreparedDisk& disk) noexcept {
    return bounds_of_cylinder(disk.world_from_object, disk.radius, disk.height, disk.height);
}

Imath::V2f uv_at(const PreparedDisk& disk, const V3d& position) noexcept {
    const V3d p = disk.object_point(position);
    return {static_cast<float>(angle_about_z(p) / disk.phi_max),
            static_cast<float>((disk.radius - std::hypot(p.x, p.y)) / (disk.radius - disk.inner_radius))};
}

}  // namespace emulsion
