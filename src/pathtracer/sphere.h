#pragma once
// Rays and spheres, in double precision: the sphere x^2 + y^2 + z^2 = r^2 of object space under any affine map, or a
// part of it.

#include <array>
#include <optional>

#include "pathtracer/quadric.h"
#include "pathtracer/scene_geometry.h"

namespace emulsion {

/// A sphere made ready for tracing.
struct PreparedSphere : QuadricFrame {
    explicit PreparedSphere(const Sphere& sphere);

    double radius;
    double z_min, z_max, phi_max;  ///< within the sphere
    bool whole;                    ///< nothing is cut off
    double object_area;            ///< before the map
    /// Set if it is whole and the map keeps shapes: centre and radius of the sphere in world space.
    std::optional<Imath::V3d> world_centre;
    double world_radius = 0.0;
};

/// The smallest t in (t_min, t_max) at which origin + t direction lies on the sphere, from outside or inside.
[[nodiscard]] std::optional<double> first_hit(const PreparedSphere& sphere, const Imath::V3f& origin,
                                              const Imath::V3f& direction, double t_min, double t_max) noexcept;

/// The surface point that `direction` of object space (any length but 0) leads to from the centre.
[[nodiscard]] QuadricPoint point_towards(const PreparedSphere& sphere, const Imath::V3d& direction) noexcept;

/// The surface point nearest, from the centre, to a world-space point that was found close to the surface.
[[nodiscard]] QuadricPoint point_at(const PreparedSphere& sphere, const Imath::V3d& near_surface) noexcept;

/// A point drawn uniformly by area of object space.
[[nodiscard]] QuadricPoint sample_area(const PreparedSphere& sphere, std::array<float, 2> u) noexcept;

/// Bounds in world space.
[[nodiscard]] Imath::Box3f bounds(const PreparedSphere& sphere) noexcept;

/// As surface_coordinates.h says, for a world-space point of the surface.
[[nodiscard]] Imath::V2f uv_at(const PreparedSphere& sphere, const Imath::V3d& position) noexcept;

}  // namespace emulsion
