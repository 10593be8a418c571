#pragma once
// Rays and spheres, in double precision: the sphere x^2 + y^2 + z^2 = r^2 of object space under any affine map.

#include <optional>

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "pathtracer/scene.h"

namespace emulsion {

/// A sphere made ready for tracing.
struct PreparedSphere {
    explicit PreparedSphere(const Sphere& sphere);

    Imath::M44d world_from_object, object_from_world;
    double radius;
    bool flip_normal;
    /// Greatest coordinate of its bounds in world space, in magnitude: what the rounding of a hit point is relative to.
    float extent;
    /// Set if the map keeps shapes: centre and radius of the sphere in world space.
    std::optional<Imath::V3d> world_centre;
    double world_radius = 0.0;
    double world_area = 0.0;  ///< set with world_centre
};

/// The smallest t in (t_min, t_max) at which origin + t direction lies on the sphere, from outside or inside.
[[nodiscard]] std::optional<double> first_hit(const PreparedSphere& sphere, const Imath::V3f& origin,
                                              const Imath::V3f& direction, double t_min, double t_max) noexcept;

/// A point of the surface in world space with its outward unit normal (turned inward if the sphere says so).
struct SpherePoint {
    Imath::V3d position, normal;
    /// World-space area per area of the object-space sphere about this point.
    double area_stretch = 1.0;
};

/// The surface point that `direction` of object space (any length but 0) leads to from the centre.
[[nodiscard]] SpherePoint point_towards(const PreparedSphere& sphere, const Imath::V3d& direction) noexcept;

/// The surface point nearest, from the centre, to a world-space point that was found close to the surface.
[[nodiscard]] SpherePoint point_at(const PreparedSphere& sphere, const Imath::V3d& near_surface) noexcept;

/// Bounds in world space.
[[nodiscard]] Imath::Box3f bounds(const PreparedSphere& sphere) noexcept;

}  // namespace emulsion
