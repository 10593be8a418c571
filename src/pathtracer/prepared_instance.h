#pragma once
// Points of an object's surfaces, where an instance has put them.

#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include "pathtracer/accelerator.h"
#include "pathtracer/surface.h"

namespace emulsion {

/// An instance made ready for shading. The map is the one that Embree has: its numbers are rounded to single precision.
struct PreparedInstance {
    explicit PreparedInstance(const Imath::M44d& exact);

    Imath::M44d world_from_object, object_from_world;
    float stretch;    ///< most by which the map makes a coordinate grow
    float condition;  ///< the same of the map times that of its inverse, >= 1
};

/// A ray of world space in the object's: t is the same along both.
[[nodiscard]] Ray object_ray(const PreparedInstance& instance, const Ray& ray) noexcept;

/// A point of the object's space in world space.
[[nodiscard]] SurfacePoint world_point(const PreparedInstance& instance, const SurfacePoint& point) noexcept;
/// And back, up to rounding.
[[nodiscard]] SurfacePoint object_point(const PreparedInstance& instance, const SurfacePoint& point) noexcept;

}  // namespace emulsion
