#include "pathtracer/surface_coordinates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

V3d object_point(const PreparedSphere& sphere, const SurfacePoint& point) noexcept {
    V3d in_object;
    sphere.object_from_world.multVecMatrix(V3d(point.position), in_object);
    return in_object;
}

V2f uv_of(const PreparedSphere& sphere, const SurfacePoint& point) noexcept {
    const V3d p = object_point(sphere, point);
    const double phi = std::atan2(p.y, p.x);
    const double theta = std::acos(std::clamp(p.z / p.length(), -1.0, 1.0));
    const double turn = 2.0 * std::numbers::pi;
    return {static_cast<float>((phi < 0.0 ? phi + turn : phi) / turn),
            static_cast<float>(1.0 - theta * std::numbers::inv_pi)};
}

V3d tangent_of(const PreparedSphere& sphere, const SurfacePoint& point) noexcept {
    const V3d p = object_point(sphere, point);
    V3d along;
    sphere.world_from_object.multDirMatrix(V3d(-p.y, p.x, 0.0), along);
    return along;
}

}  // namespace

V2f surface_uv(const PreparedScene& scene, const Hit& hit, const SurfacePoint& point) noexcept {
    const auto& shape = scene.shape(hit.shape);
    return shape.mesh != nullptr ? uv_of(*shape.mesh, hit) : uv_of(*shape.sphere, point);
}

V3f surface_tangent(const PreparedScene& scene, const Hit& hit, const SurfacePoint& point) noexcept {
    const auto& shape = scene.shape(hit.shape);
    const V3d along = shape.mesh != nullptr ? tangent_of(*shape.mesh, hit) : tangent_of(*shape.sphere, point);
    const V3d normal(point.shading_normal);
    const V3d in_surface = along - normal * along.dot(normal);
    const double length = in_surface.length();
    // What is left after the subtraction must be more than its rounding.
    if (!(length > 1e-6 * along.length())) return Frame(point.shading_normal).tangent;
    return V3f(in_surface / length);
}

}  // namespace emulsion
