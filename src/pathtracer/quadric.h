#pragma once
// What spheres, disks and cylinders have in common: a space of their own, and points of a surface.

#include <cmath>
#include <numbers>

#include <Imath/ImathBox.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

namespace emulsion {

/// A point of the surface in world space with its unit normal.
struct QuadricPoint {
    Imath::V3d position, normal;
    /// World-space area per area of the object-space surface about this point.
    double area_stretch = 1.0;
};

/// The maps between object space and world space, in Imath's row-vector convention.
struct QuadricFrame {
    Imath::M44d world_from_object, object_from_world;
    bool flip_normal = false;

    explicit QuadricFrame(const Imath::M44d& map, bool flip = false)
        : world_from_object(map), object_from_world(map.inverse(true)), flip_normal(flip) {}

    [[nodiscard]] Imath::V3d object_point(const Imath::V3d& world) const noexcept {
        Imath::V3d object;
        object_from_world.multVecMatrix(world, object);
        return object;
    }
    [[nodiscard]] Imath::V3d object_vector(const Imath::V3d& world) const noexcept {
        Imath::V3d object;
        object_from_world.multDirMatrix(world, object);
        return object;
    }
    [[nodiscard]] Imath::V3d world_vector(const Imath::V3d& object) const noexcept {
        Imath::V3d world;
        world_from_object.multDirMatrix(object, world);
        return world;
    }
    /// `normal` is the unit normal of the surface in object space.
    [[nodiscard]] QuadricPoint world_point(const Imath::V3d& position, const Imath::V3d& normal) const noexcept;
};

/// Angle about z from +x over +y, in [0, 2 pi).
[[nodiscard]] inline double angle_about_z(const Imath::V3d& p) noexcept {
    const double phi = std::atan2(p.y, p.x);
    return phi < 0.0 ? phi + 2.0 * std::numbers::pi : phi;
}

/// dp/du at a world-space point of the surface, for any of them: about the z axis of object space. Not normalised.
[[nodiscard]] Imath::V3d tangent_at(const QuadricFrame& quadric, const Imath::V3d& position) noexcept;

/// World-space bounds of what is on a circle of `radius` at height z and below one at height z_top.
[[nodiscard]] Imath::Box3f bounds_of_cylinder(const Imath::M44d& world_from_object, double radius, double z,
                                              double z_top) noexcept;

}  // namespace emulsion
