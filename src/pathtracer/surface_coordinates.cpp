#include "pathtracer/surface_coordinates.h"

#include <array>
#include <cmath>
#include <variant>

#include "pathtracer/bilinear.h"

namespace emulsion {

namespace {

using Imath::V2f;
using Imath::V3d;
using Imath::V3f;

std::array<V2f, 3> corner_uv(const TriangleMesh& mesh, std::uint32_t triangle) noexcept {
    if (mesh.uv.empty()) return {V2f(0.0f, 0.0f), V2f(1.0f, 0.0f), V2f(1.0f, 1.0f)};
    const auto& corner = mesh.triangle[triangle];
    return {mesh.uv[corner[0]], mesh.uv[corner[1]], mesh.uv[corner[2]]};
}

V2f uv_of(const TriangleMesh& mesh, const Hit& hit) noexcept {
    const auto [a, b, c] = corner_uv(mesh, hit.primitive);
    return a * (1.0f - hit.u - hit.v) + b * hit.u + c * hit.v;
}

/// dp/du, or the mesh's own tangent; 0 if there is neither. In double precision: uv may be as close as rounding lets.
V3d tangent_of(const TriangleMesh& mesh, const Hit& hit) noexcept {
    const auto& corner = mesh.triangle[hit.primitive];
    if (!mesh.tangent.empty()) {
        const V3f interpolated = mesh.tangent[corner[0]] * (1.0f - hit.u - hit.v) + mesh.tangent[corner[1]] * hit.u +
                                 mesh.tangent[corner[2]] * hit.v;
        if (interpolated != V3f(0.0f)) return V3d(interpolated);
    }
    // p = p0 + b1 edge1 + b2 edge2 and (u, v) = uv0 + b1 d1 + b2 d2: solved for b1 and b2 at constant v.
    const auto [uv0, uv1, uv2] = corner_uv(mesh, hit.primitive);
    const Imath::V2d d1 = Imath::V2d(uv1) - Imath::V2d(uv0), d2 = Imath::V2d(uv2) - Imath::V2d(uv0);
    const double determinant = d1.x * d2.y - d1.y * d2.x;
    if (std::abs(determinant) < 1e-9) return V3d(0.0);  // pbrt-v4's limit
    const V3d p0(mesh.position[corner[0]]);
    const V3d edge1 = V3d(mesh.position[corner[1]]) - p0, edge2 = V3d(mesh.position[corner[2]]) - p0;
    return (edge1 * d2.y - edge2 * d1.y) * (1.0 / determinant);
}

/// pbrt-v4's dp/ds of a patch: with texture coordinates (s, t) of its own, the sum of what du/ds and dv/ds give, each
/// taken for the inverse of ds/du and ds/dv.
V3d tangent_of(const BilinearMesh& mesh, const Hit& hit) noexcept {
    const BilinearPatch patch(mesh, hit.primitive);
    const Imath::V2d uv = patch_uv(mesh, hit);
    const V3d du = patch.dp_du(uv.y), dv = patch.dp_dv(uv.x);
    if (mesh.uv.empty()) return du;
    const auto& corner = mesh.patch[hit.primitive];
    const auto s = [&](std::size_t i) { return static_cast<double>(mesh.uv[corner[i]].x); };
    const double mixed = s(0) - s(1) - s(2) + s(3);
    const double ds_du = s(1) - s(0) + uv.y * mixed, ds_dv = s(2) - s(0) + uv.x * mixed;
    const auto inverse = [](double x) { return std::abs(x) < 1e-8 ? 0.0 : 1.0 / x; };
    const V3d along = du * inverse(ds_du) + dv * inverse(ds_dv);
    return along == V3d(0.0) ? du : along;
}

V2f uv_of(const BilinearMesh& mesh, const Hit& hit) noexcept {
    const V2f uv(patch_uv(mesh, hit));
    if (mesh.uv.empty()) return uv;
    const auto& corner = mesh.patch[hit.primitive];
    return (mesh.uv[corner[0]] * (1.0f - uv.x) + mesh.uv[corner[1]] * uv.x) * (1.0f - uv.y) +
           (mesh.uv[corner[2]] * (1.0f - uv.x) + mesh.uv[corner[3]] * uv.x) * uv.y;
}

/// In the space of the shape.
V2f uv_of(const PreparedScene::PreparedShape& shape, const Hit& hit, const SurfacePoint& point) noexcept {
    if (shape.mesh != nullptr) return uv_of(*shape.mesh, hit);
    if (shape.patches != nullptr) return uv_of(*shape.patches, hit);
    return std::visit([&](const auto& quadric) { return uv_at(quadric, V3d(point.position)); }, *shape.quadric);
}

/// The same of dp/du, of any length; 0 if there is none.
V3d tangent_of(const PreparedScene::PreparedShape& shape, const Hit& hit, const SurfacePoint& point) noexcept {
    if (shape.mesh != nullptr) return tangent_of(*shape.mesh, hit);
    if (shape.patches != nullptr) return tangent_of(*shape.patches, hit);
    return std::visit([&](const auto& quadric) { return tangent_at(quadric, V3d(point.position)); }, *shape.quadric);
}

}  // namespace

V2f surface_uv(const PreparedScene& scene, const Hit& hit, const SurfacePoint& point) noexcept {
    const auto& shape = scene.shape(hit.shape);
    if (hit.instance == Hit::kNone) return uv_of(shape, hit, point);
    return uv_of(shape, hit, object_point(scene.instance(hit.instance), point));
}

V3f surface_tangent(const PreparedScene& scene, const Hit& hit, const SurfacePoint& point) noexcept {
    const auto& shape = scene.shape(hit.shape);
    V3d along;
    if (hit.instance == Hit::kNone) {
        along = tangent_of(shape, hit, point);
    } else {
        const PreparedInstance& instance = scene.instance(hit.instance);
        instance.world_from_object.multDirMatrix(tangent_of(shape, hit, object_point(instance, point)), along);
    }
    const V3d normal(point.shading_normal);
    const V3d in_surface = along - normal * along.dot(normal);
    const double length = in_surface.length();
    // What is left after the subtraction must be more than its rounding.
    if (!(length > 1e-6 * along.length())) return Frame(point.shading_normal).tangent;
    return V3f(in_surface / length);
}

}  // namespace emulsion
