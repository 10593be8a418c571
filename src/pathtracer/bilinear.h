#pragma once
// Rays and bilinear patches, in double precision.
// Source: Reshetov, "Cool Patches: A Geometric Approach to Ray/Bilinear Patch Intersections", Ray Tracing Gems, 2019.

#include <array>
#include <cstdint>
#include <optional>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "pathtracer/scene_geometry.h"

namespace emulsion {

/// One patch of a mesh: p(u, v) is linear in u and in v, both in [0, 1].
struct BilinearPatch {
    Imath::V3d p00, p10, p01, p11;

    BilinearPatch(const BilinearMesh& mesh, std::uint32_t patch) noexcept;

    [[nodiscard]] Imath::V3d at(double u, double v) const noexcept {
        return (p00 * (1.0 - u) + p10 * u) * (1.0 - v) + (p01 * (1.0 - u) + p11 * u) * v;
    }
    [[nodiscard]] Imath::V3d dp_du(double v) const noexcept { return (p10 - p00) * (1.0 - v) + (p11 - p01) * v; }
    [[nodiscard]] Imath::V3d dp_dv(double u) const noexcept { return (p01 - p00) * (1.0 - u) + (p11 - p10) * u; }
    /// dp/du x dp/dv: as long as the patch has area per area of (u, v).
    [[nodiscard]] Imath::V3d cross(double u, double v) const noexcept { return dp_du(v).cross(dp_dv(u)); }
};

struct BilinearHit {
    double t = 0.0, u = 0.0, v = 0.0;
};

/// The first of the points origin + t direction, t in (t_min, t_max), that lies on the patch.
[[nodiscard]] std::optional<BilinearHit> first_hit(const BilinearPatch& patch, const Imath::V3d& origin,
                                                   const Imath::V3d& direction, double t_min, double t_max) noexcept;

/// Where `position`, a point of the patch but for rounding, has its (u, v). For flat convex patches always right; of
/// others it takes the one to which (u, v) = (1/2, 1/2) leads.
[[nodiscard]] Imath::V2d patch_uv(const BilinearPatch& patch, const Imath::V3d& position) noexcept;

/// Flat to 1e-5 of the longer diagonal, and a walk round the corners never turns the other way. Corners may coincide,
/// or all lie in one line.
[[nodiscard]] bool is_flat_and_convex(const BilinearPatch& patch) noexcept;

/// As pbrt-v4 has it: of a parallelogram exact, else that of nine flat pieces.
[[nodiscard]] double area_of(const BilinearPatch& patch) noexcept;

[[nodiscard]] Imath::Box3f bounds(const BilinearPatch& patch) noexcept;

}  // namespace emulsion
