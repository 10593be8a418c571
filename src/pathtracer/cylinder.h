#pragma once
// Rays and cylinders, in double precision: x^2 + y^2 = r^2 of object space between two heights, or a part of it, under
// any affine map.

#include <array>
#include <optional>

#include "pathtracer/quadric.h"
#include "pathtracer/scene_geometry.h"

namespace emulsion {

/// A cylinder made ready for tracing. The functions are those of spheres (sphere.h).
struct PreparedCylinder : QuadricFrame {
    explicit PreparedCylinder(const Cylinder& cylinder);

    double radius, z_min, z_max, phi_max;
    double object_area;  ///< before the map
};

[[nodiscard]] std::optional<double> first_hit(const PreparedCylinder& cylinder, const Imath::V3f& origin,
                                              const Imath::V3f& direction, double t_min, double t_max) noexcept;
/// The nearest, across the axis.
[[nodiscard]] QuadricPoint point_at(const PreparedCylinder& cylinder, const Imath::V3d& near_surface) noexcept;
[[nodiscard]] QuadricPoint sample_area(const PreparedCylinder& cylinder, std::array<float, 2> u) noexcept;
[[nodiscard]] Imath::Box3f bounds(const PreparedCylinder& cylinder) noexcept;
/// u = phi / phi_max, v = (z - z_min) / (z_max - z_min).
[[nodiscard]] Imath::V2f uv_at(const PreparedCylinder& cylinder, const Imath::V3d& position) noexcept;

}  // namespace emulsion
