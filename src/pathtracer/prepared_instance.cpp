#include "pathtracer/prepared_instance.h"

#include <algorithm>
#include <cmath>

namespace emulsion {

namespace {

using Imath::M44d;
using Imath::V3d;
using Imath::V3f;

M44d rounded(const M44d& m) noexcept {
    M44d single = m;
    for (int row = 0; row < 4; ++row) {
        for (int axis = 0; axis < 3; ++axis) single[row][axis] = static_cast<double>(static_cast<float>(m[row][axis]));
    }
    return single;
}

/// Most that a coordinate can be of what the largest was.
double largest_column(const M44d& m) noexcept {
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        largest = std::max(largest, std::abs(m[0][axis]) + std::abs(m[1][axis]) + std::abs(m[2][axis]));
    }
    return largest;
}

V3f mapped_point(const M44d& m, const V3f& p) noexcept {
    V3d out;
    m.multVecMatrix(V3d(p), out);
    return V3f(out);
}

/// By the inverse transpose of a map of which `inverse` is the inverse.
V3f mapped_normal(const M44d& inverse, const V3f& normal) noexcept {
    const auto& m = inverse.x;
    const V3d n(normal);
    return V3f(V3d(m[0][0] * n.x + m[0][1] * n.y + m[0][2] * n.z, m[1][0] * n.x + m[1][1] * n.y + m[1][2] * n.z,
                   m[2][0] * n.x + m[2][1] * n.y + m[2][2] * n.z)
                   .normalized());
}

}  // namespace

PreparedInstance::PreparedInstance(const M44d& exact)
    : world_from_object(rounded(exact)),
      object_from_world(world_from_object.inverse(true)),
      stretch(static_cast<float>(largest_column(world_from_object))),
      condition(static_cast<float>(largest_column(world_from_object) * largest_column(object_from_world))) {}

Ray object_ray(const PreparedInstance& instance, const Ray& ray) noexcept {
    V3d direction;
    instance.object_from_world.multDirMatrix(V3d(ray.direction), direction);
    return {mapped_point(instance.object_from_world, ray.origin), V3f(direction), ray.t_max};
}

SurfacePoint world_point(const PreparedInstance& instance, const SurfacePoint& point) noexcept {
    SurfacePoint world{mapped_point(instance.world_from_object, point.position),
                       mapped_normal(instance.object_from_world, point.geometric_normal),
                       mapped_normal(instance.object_from_world, point.shading_normal)};
    // Embree maps the ray's origin by a rounded inverse, in single precision, before it looks at the shape.
    const float coordinate =
        max_abs_component(world.position) + max_abs_component(V3f(instance.world_from_object.translation()));
    world.offset = instance.stretch * point.offset + kPositionOffset * instance.condition * coordinate;
    return world;
}

SurfacePoint object_point(const PreparedInstance& instance, const SurfacePoint& point) noexcept {
    return {mapped_point(instance.object_from_world, point.position),
            mapped_normal(instance.world_from_object, point.geometric_normal),
            mapped_normal(instance.world_from_object, point.shading_normal)};
}

}  // namespace emulsion
