#pragma once
// From a hit to the point of the surface, and from there to the next ray.

#include <cmath>
#include <span>

#include <Imath/ImathVec.h>

#include "pathtracer/accelerator.h"
#include "pathtracer/scene.h"
#include "pathtracer/sphere.h"
#include "pathtracer/vector_math.h"

namespace emulsion {

/// How far, relative to the largest coordinate nearby, rays start above a surface: 32 roundings of single precision,
/// four times the error of an interpolated position.
inline constexpr float kRelativeOffset = 0x1p-19f;

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

/// A triangle's corners, and what follows from them.
struct TriangleGeometry {
    Imath::V3f p0, edge1, edge2;
    Imath::V3f normal;    ///< unit; on the side that area lights emit to
    float area = 0.0f;    ///< >= 0
    float offset = 0.0f;  ///< as in SurfacePoint

    TriangleGeometry(const TriangleMesh& mesh, std::uint32_t triangle) noexcept {
        const auto& corner = mesh.triangle[triangle];
        p0 = mesh.position[corner[0]];
        edge1 = mesh.position[corner[1]] - p0;
        edge2 = mesh.position[corner[2]] - p0;
        // The fourth power of a length leaves single precision for coordinates of 1e10 and of 1e-10.
        const Imath::V3d cross = Imath::V3d(edge1).cross(Imath::V3d(edge2));
        const double length = std::sqrt(cross.dot(cross));
        area = static_cast<float>(0.5 * length);
        // A triangle without area is never met; its normal must be a number all the same.
        normal = length > 0.0 ? Imath::V3f(cross * ((mesh.flip_normal ? -1.0 : 1.0) / length)) : Imath::V3f(0, 0, 1);
        const float extent = std::max({max_abs_component(p0), max_abs_component(mesh.position[corner[1]]),
                                       max_abs_component(mesh.position[corner[2]])});
        offset = kRelativeOffset * extent;
    }
    [[nodiscard]] Imath::V3f at(float u, float v) const noexcept { return p0 + edge1 * u + edge2 * v; }
};

/// With normals at the corners, their interpolation also says on which side the geometric normal is, as in pbrt-v4.
[[nodiscard]] inline SurfacePoint surface_point(const TriangleMesh& mesh, const TriangleGeometry& triangle,
                                                const Hit& hit) noexcept {
    SurfacePoint point{triangle.at(hit.u, hit.v), triangle.normal, triangle.normal, triangle.offset};
    if (!mesh.normal.empty()) {
        const auto& corner = mesh.triangle[hit.primitive];
        const Imath::V3f interpolated = mesh.normal[corner[0]] * (1.0f - hit.u - hit.v) +
                                        mesh.normal[corner[1]] * hit.u + mesh.normal[corner[2]] * hit.v;
        if (interpolated.dot(interpolated) > 0.0f) {
            point.shading_normal = unit(interpolated);
            if (point.geometric_normal.dot(interpolated) < 0.0f) point.geometric_normal = -point.geometric_normal;
        }
    }
    return point;
}

[[nodiscard]] inline SurfacePoint surface_point(const PreparedSphere& sphere, const SpherePoint& point) noexcept {
    const Imath::V3f normal(point.normal);
    return {Imath::V3f(point.position), normal, normal, kRelativeOffset * sphere.extent};
}

}  // namespace emulsion
