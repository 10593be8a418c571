#include "pathtracer/embree_user_geometry.h"

#include <limits>
#include <optional>
#include <variant>

#include "pathtracer/accelerator.h"
#include "pathtracer/bilinear.h"

namespace emulsion {

namespace {

// --- A mesh of patches, or one quadric

std::optional<BilinearHit> first_hit_of(const BilinearMesh& mesh, unsigned patch, const Ray& ray) {
    return first_hit(BilinearPatch(mesh, patch), Imath::V3d(ray.origin), Imath::V3d(ray.direction), 0.0,
                     static_cast<double>(ray.t_max));
}
template <class Quadric>
std::optional<BilinearHit> first_hit_of(const Quadric& quadric, unsigned, const Ray& ray) {
    const auto t = first_hit(quadric, ray.origin, ray.direction, 0.0, static_cast<double>(ray.t_max));
    return t ? std::optional<BilinearHit>({*t, 0.0, 0.0}) : std::nullopt;
}

Imath::Box3f bounds_of(const BilinearMesh& mesh, unsigned patch) { return bounds(BilinearPatch(mesh, patch)); }
template <class Quadric>
Imath::Box3f bounds_of(const Quadric& quadric, unsigned) {
    return bounds(quadric);
}

Ray ray_of_lane(RTCRayN* ray, unsigned n, unsigned lane) {
    return {{RTCRayN_org_x(ray, n, lane), RTCRayN_org_y(ray, n, lane), RTCRayN_org_z(ray, n, lane)},
            {RTCRayN_dir_x(ray, n, lane), RTCRayN_dir_y(ray, n, lane), RTCRayN_dir_z(ray, n, lane)},
            RTCRayN_tfar(ray, n, lane)};
}

template <class Geometry>
void bounds_callback(const RTCBoundsFunctionArguments* args) {
    const Imath::Box3f box = bounds_of(*static_cast<const Geometry*>(args->geometryUserPtr), args->primID);
    *args->bounds_o = {box.min.x, box.min.y, box.min.z, 0.0f, box.max.x, box.max.y, box.max.z, 0.0f};
}

template <class Geometry>
void intersect_callback(const RTCIntersectFunctionNArguments* args) {
    const auto& geometry = *static_cast<const Geometry*>(args->geometryUserPtr);
    RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, args->N);
    RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, args->N);
    for (unsigned lane = 0; lane < args->N; ++lane) {
        if (args->valid[lane] == 0) continue;
        const auto met = first_hit_of(geometry, args->primID, ray_of_lane(ray, args->N, lane));
        if (!met) continue;
        RTCRayN_tfar(ray, args->N, lane) = static_cast<float>(met->t);
        RTCHitN_u(hit, args->N, lane) = static_cast<float>(met->u);
        RTCHitN_v(hit, args->N, lane) = static_cast<float>(met->v);
        RTCHitN_geomID(hit, args->N, lane) = args->geomID;
        RTCHitN_primID(hit, args->N, lane) = args->primID;
        RTCHitN_instID(hit, args->N, lane, 0) = args->context->instID[0];
    }
}

template <class Geometry>
void occluded_callback(const RTCOccludedFunctionNArguments* args) {
    const auto& geometry = *static_cast<const Geometry*>(args->geometryUserPtr);
    for (unsigned lane = 0; lane < args->N; ++lane) {
        if (args->valid[lane] == 0) continue;
        if (first_hit_of(geometry, args->primID, ray_of_lane(args->ray, args->N, lane))) {
            RTCRayN_tfar(args->ray, args->N, lane) = -std::numeric_limits<float>::infinity();
        }
    }
}

/// Embree only reads through the pointer, and hands it back.
template <class Geometry>
RTCGeometry make_geometry(RTCDevice device, const Geometry& shape, std::size_t primitives) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(primitives));
    rtcSetGeometryUserData(geometry, const_cast<Geometry*>(&shape));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
    rtcSetGeometryBoundsFunction(geometry, bounds_callback<Geometry>, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_callback<Geometry>);
    rtcSetGeometryOccludedFunction(geometry, occluded_callback<Geometry>);
    return geometry;
}

}  // namespace

RTCGeometry user_geometry(RTCDevice device, const BilinearMesh& mesh) {
    return make_geometry(device, mesh, mesh.patch.size());
}

RTCGeometry user_geometry(RTCDevice device, const PreparedQuadric& quadric) {
    return std::visit([&](const auto& shape) { return make_geometry(device, shape, 1); }, quadric);
}

}  // namespace emulsion
