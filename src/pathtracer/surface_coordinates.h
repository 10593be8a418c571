#pragma once
// Where a point lies on its shape, for those who ask: texture coordinates, and the direction in which u grows. As in
// pbrt-v4:
//   triangle  interpolated from the mesh; (0, 0), (1, 0), (1, 1) at the corners of a mesh without uv
//   patch     bilinear from the mesh; the patch's own (u, v) without uv
//   sphere    u = phi / phi_max, v = (theta - theta_min) / (theta_max - theta_min), with theta from +z and theta_min
//             at the lower end: v = 0 there
//   disk      u = phi / phi_max, v from 0 at the outer edge to 1 at the inner one
//   cylinder  u = phi / phi_max, v = (z - z_min) / (z_max - z_min)
// Kept apart from SurfacePoint, as most points never need them.

#include <Imath/ImathVec.h>

#include "pathtracer/prepared_scene.h"

namespace emulsion {

/// Texture coordinates of a hit, of which `point` is the surface_point().
[[nodiscard]] Imath::V2f surface_uv(const PreparedScene& scene, const Hit& hit, const SurfacePoint& point) noexcept;

/// Unit vector at right angles to the shading normal, in the direction in which u grows (or the mesh's own tangent).
/// Where there is none (the poles of a sphere, a triangle with uv in one line), any that is at right angles.
[[nodiscard]] Imath::V3f surface_tangent(const PreparedScene& scene, const Hit& hit,
                                         const SurfacePoint& point) noexcept;

}  // namespace emulsion
