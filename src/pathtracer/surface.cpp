#include "pathtracer/surface.h"

#include "pathtracer/bilinear.h"

namespace emulsion {

namespace {

using Imath::V2d;
using Imath::V3d;
using Imath::V3f;

/// Flat patches are met as Embree's quadrilaterals p00 p10 p11 p01, which are two triangles: p00 p10 p01 with its own
/// barycentric coordinates, and p11 p01 p10 with one minus its own.
V3d position_on_flat(const BilinearPatch& patch, double u, double v) noexcept {
    if (u + v <= 1.0) return patch.p00 + (patch.p10 - patch.p00) * u + (patch.p01 - patch.p00) * v;
    return patch.p11 + (patch.p01 - patch.p11) * (1.0 - u) + (patch.p10 - patch.p11) * (1.0 - v);
}

float extent_of(const BilinearPatch& patch) noexcept {
    return std::max({max_abs_component(V3f(patch.p10 - patch.p00)), max_abs_component(V3f(patch.p01 - patch.p00)),
                     max_abs_component(V3f(patch.p11 - patch.p00))});
}

V3f interpolated_normal(const BilinearMesh& mesh, std::uint32_t patch, const V2d& uv) noexcept {
    const auto& corner = mesh.patch[patch];
    const auto u = static_cast<float>(uv.x), v = static_cast<float>(uv.y);
    return (mesh.normal[corner[0]] * (1.0f - u) + mesh.normal[corner[1]] * u) * (1.0f - v) +
           (mesh.normal[corner[2]] * (1.0f - u) + mesh.normal[corner[3]] * u) * v;
}

/// Without the normals of the corners. `cross` is dp/du x dp/dv.
SurfacePoint geometric_point(const BilinearMesh& mesh, const BilinearPatch& patch, const V3d& position,
                             const V3d& cross) noexcept {
    const double length = cross.length();
    const V3f normal = length > 0.0 ? V3f(cross * ((mesh.flip_normal ? -1.0 : 1.0) / length)) : V3f(0, 0, 1);
    const V3f rounded(position);
    return {rounded, normal, normal,
            kPositionOffset * max_abs_component(rounded) + kFaceOffset * (mesh.flat ? extent_of(patch) : 0.0f)};
}

}  // namespace

V2d patch_uv(const BilinearMesh& mesh, const Hit& hit) noexcept {
    const V2d of_hit(static_cast<double>(hit.u), static_cast<double>(hit.v));
    if (!mesh.flat) return of_hit;
    const BilinearPatch patch(mesh, hit.primitive);
    return patch_uv(patch, position_on_flat(patch, of_hit.x, of_hit.y));
}

SurfacePoint surface_point(const BilinearMesh& mesh, const Hit& hit) noexcept {
    if (!mesh.flat) return surface_point(mesh, hit.primitive, patch_uv(mesh, hit));
    const BilinearPatch patch(mesh, hit.primitive);
    const V3d position = position_on_flat(patch, static_cast<double>(hit.u), static_cast<double>(hit.v));
    SurfacePoint point = geometric_point(mesh, patch, position, (patch.p11 - patch.p00).cross(patch.p01 - patch.p10));
    if (!mesh.normal.empty()) {
        set_shading_normal(point, interpolated_normal(mesh, hit.primitive, patch_uv(patch, position)));
    }
    return point;
}

SurfacePoint surface_point(const BilinearMesh& mesh, std::uint32_t index, const V2d& uv) noexcept {
    const BilinearPatch patch(mesh, index);
    SurfacePoint point = geometric_point(mesh, patch, patch.at(uv.x, uv.y), patch.cross(uv.x, uv.y));
    if (!mesh.normal.empty()) set_shading_normal(point, interpolated_normal(mesh, index, uv));
    return point;
}

}  // namespace emulsion
