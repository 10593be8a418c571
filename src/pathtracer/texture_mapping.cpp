#include "pathtracer/texture_mapping.h"

#include <cmath>
#include <numbers>

#include "core/visit.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

using Imath::V2d;
using Imath::V3d;

constexpr double kInvPi = std::numbers::inv_pi;

V2d map_one(const UvMapping& mapping, const TexturePoint& point) noexcept {
    return {mapping.scale_u * static_cast<double>(point.uv.x) + mapping.delta_u,
            mapping.scale_v * static_cast<double>(point.uv.y) + mapping.delta_v};
}

V2d map_one(const SphericalTextureMapping& mapping, const TexturePoint& point) noexcept {
    const V3d p = transform_point(mapping.texture_from_world, V3d(point.position));
    const double theta = std::atan2(std::hypot(p.x, p.y), p.z), phi = std::atan2(p.y, p.x);
    return {theta * kInvPi, 0.5 * kInvPi * phi + (phi < 0.0 ? 1.0 : 0.0)};
}

V2d map_one(const CylindricalTextureMapping& mapping, const TexturePoint& point) noexcept {
    const V3d p = transform_point(mapping.texture_from_world, V3d(point.position));
    return {0.5 + 0.5 * kInvPi * std::atan2(p.y, p.x), p.z};
}

V2d map_one(const PlanarTextureMapping& mapping, const TexturePoint& point) noexcept {
    const V3d p = transform_point(mapping.texture_from_world, V3d(point.position));
    return {p.dot(mapping.along_u) + mapping.delta_u, p.dot(mapping.along_v) + mapping.delta_v};
}

}  // namespace

V3d map(const SolidTextureMapping& mapping, const TexturePoint& point) noexcept {
    return transform_point(mapping.texture_from_world, V3d(point.position));
}

V2d map(const TextureMapping& mapping, const TexturePoint& point) noexcept {
    return visit_noexcept([&](const auto& chosen) noexcept { return map_one(chosen, point); }, mapping);
}

}  // namespace emulsion
