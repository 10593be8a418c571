#pragma once
// From a hit to the point of the surface, and from there to the next ray.

#include <algorithm>
#include <cmath>

#include <Imath/ImathVec.h>

#include "pathtracer/accelerator.h"
#include "pathtracer/quadrics.h"
#include "pathtracer/scene_geometry.h"
#include "pathtracer/vector_math.h"

namespace emulsion {

/// How far rays start above a surface, relative to the largest coordinate of the point. The point and the ray's origin
/// are each rounded, by at most half a unit in the last place and sqrt(3) of these along the normal: 2^-22.2 in all.
/// Measured with triangles of 1/1000 of their distance: 2^-24 is too little for 2% of the rays, 2^-23 enough for all.
inline constexpr float kPositionOffset = 0x1p-22f;

/// The same relative to the extent of a flat face: Embree subtracts the ray's origin from the corners in single
/// precision, and so misjudges on which side of the face's plane it lies. Measured with quadrilaterals at a distance of
/// their own size, along the surface: 2^-25 is too little for 20 rays in a million, 2^-24 enough for all.
inline constexpr float kFaceOffset = 0x1p-22f;

struct SurfacePoint {
    Imath::V3f position;
    Imath::V3f geometric_normal;  ///< unit; area lights emit to its side
    Imath::V3f shading_normal;    ///< unit
    float offset = 0.0f;          ///< distance by which rays start off the surface

    /// Where a ray towards `direction` starts, so that it does not meet the surface that it leaves.
    [[nodiscard]] Imath::V3f origin_towards(const Imath::V3f& direction) const noexcept {
        return position + geometric_normal * std::copysign(offset, direction.dot(geometric_normal));
    }
};

/// A corner of a triangle, and the edges that start there. In double precision: a point that is interpolated between
/// corners far away would leave the plane by their rounding, and not by its own.
struct TriangleEdges {
    Imath::V3d p0, edge1, edge2;

    TriangleEdges(const TriangleMesh& mesh, std::uint32_t triangle) noexcept {
        const auto& corner = mesh.triangle[triangle];
        p0 = Imath::V3d(mesh.position[corner[0]]);
        edge1 = Imath::V3d(mesh.position[corner[1]]) - p0;
        edge2 = Imath::V3d(mesh.position[corner[2]]) - p0;
    }
    [[nodiscard]] Imath::V3d at(float u, float v) const noexcept {
        return p0 + edge1 * static_cast<double>(u) + edge2 * static_cast<double>(v);
    }
};

/// What a triangle's edges say of it as a whole.
struct TriangleFace {
    double area = 0.0;        ///< >= 0
    Imath::V3f normal{0.0f};  ///< unit; turned round if the mesh says so
    float extent = 0.0;       ///< the largest coordinate of an edge, in magnitude

    TriangleFace() = default;
    TriangleFace(const TriangleMesh& mesh, const TriangleEdges& edges) noexcept {
        const Imath::V3d cross = edges.edge1.cross(edges.edge2);
        const double length = std::sqrt(cross.dot(cross));
        area = 0.5 * length;
        // A triangle without area is never met; its normal must be a number all the same.
        normal = length > 0.0 ? Imath::V3f(cross * ((mesh.flip_normal ? -1.0 : 1.0) / length)) : Imath::V3f(0, 0, 1);
        extent = std::max(max_abs_component(Imath::V3f(edges.edge1)), max_abs_component(Imath::V3f(edges.edge2)));
    }
};

/// Gives a point the shading normal that was interpolated between a face's corners, unless that is 0; it also says on
/// which side the geometric normal is, as in pbrt-v4.
inline void set_shading_normal(SurfacePoint& point, const Imath::V3f& interpolated) noexcept {
    const float length2 = interpolated.dot(interpolated);
    if (!(length2 > 0.0f)) return;
    point.shading_normal = interpolated * (1.0f / std::sqrt(length2));
    if (point.geometric_normal.dot(interpolated) < 0.0f) point.geometric_normal = -point.geometric_normal;
}

[[nodiscard]] inline SurfacePoint surface_point(const TriangleMesh& mesh, const TriangleEdges& edges,
                                                const TriangleFace& face, const Hit& hit) noexcept {
    const Imath::V3f position(edges.at(hit.u, hit.v));
    SurfacePoint point{position, face.normal, face.normal,
                       kPositionOffset * max_abs_component(position) + kFaceOffset * face.extent};
    if (!mesh.normal.empty()) {
        const auto& corner = mesh.triangle[hit.primitive];
        set_shading_normal(point, mesh.normal[corner[0]] * (1.0f - hit.u - hit.v) + mesh.normal[corner[1]] * hit.u +
                                      mesh.normal[corner[2]] * hit.v);
    }
    return point;
}

[[nodiscard]] inline SurfacePoint surface_point(const TriangleMesh& mesh, const Hit& hit) noexcept {
    const TriangleEdges edges(mesh, hit.primitive);
    return surface_point(mesh, edges, TriangleFace(mesh, edges), hit);
}

/// The (u, v) of a patch at a hit: of a mesh that is not flat, the hit's own.
[[nodiscard]] Imath::V2d patch_uv(const BilinearMesh& mesh, const Hit& hit) noexcept;

/// At a hit of a patch.
[[nodiscard]] SurfacePoint surface_point(const BilinearMesh& mesh, const Hit& hit) noexcept;

/// At (u, v) of patch number `index`.
[[nodiscard]] SurfacePoint surface_point(const BilinearMesh& mesh, std::uint32_t index, const Imath::V2d& uv) noexcept;

/// Quadrics are intersected in double precision: only the point itself and the ray's origin are rounded.
[[nodiscard]] inline SurfacePoint surface_point(const QuadricPoint& point) noexcept {
    const Imath::V3f position(point.position), normal(point.normal);
    return {position, normal, normal, kPositionOffset * max_abs_component(position)};
}

}  // namespace emulsion
