#pragma once
// Rays and disks, in double precision: rings, or parts of them, at right angles to the z axis of object space, under
// any affine map.

#include <array>
#include <optional>

#include "pathtracer/quadric.h"
#include "pathtracer/scene_geometry.h"

namespace emulsion {

/// A disk made ready for tracing. The functions are those of spheres (sphere.h).
struct PreparedDisk : QuadricFrame {
    explicit PreparedDisk(const Disk& disk);

    double height, radius, inner_radius, phi_max;
    double object_area;  ///< before the map
};

[[nodiscard]] std::optional<double> first_hit(const PreparedDisk& disk, const Imath::V3f& origin,
                                              const Imath::V3f& direction, double t_min, double t_max) noexcept;
[[nodiscard]] QuadricPoint point_at(const PreparedDisk& disk, const Imath::V3d& near_surface) noexcept;
[[nodiscard]] QuadricPoint sample_area(const PreparedDisk& disk, std::array<float, 2> u) noexcept;
[[nodiscard]] Imath::Box3f bounds(const PreparedDisk& disk) noexcept;
/// u = phi / phi_max; v = 0 at the outer edge and 1 at the inner one.
[[nodiscard]] Imath::V2f uv_at(const PreparedDisk& disk, const Imath::V3d& position) noexcept;

}  // namespace emulsion
