#include "pathtracer/accelerator.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "pathtracer/embree.h"
#include "pathtracer/sphere.h"

namespace emulsion {

struct Accelerator::Embree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    int packet_width = 4;
    std::vector<std::unique_ptr<PreparedSphere>> spheres;  // Embree keeps their addresses

    Embree() = default;
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    ~Embree() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void check(const char* step) const {
        const RTCError error = rtcGetDeviceError(device);
        if (error != RTC_ERROR_NONE) {
            throw std::runtime_error(std::string("Embree failed while ") + step + ": error code " +
                                     std::to_string(static_cast<int>(error)));
        }
    }
};

namespace {

// --- Spheres as user geometry -----------------------------------------------------------------------------------------

void sphere_bounds(const RTCBoundsFunctionArguments* args) {
    const Imath::Box3f box = bounds(*static_cast<const PreparedSphere*>(args->geometryUserPtr));
    *args->bounds_o = {box.min.x, box.min.y, box.min.z, 0.0f, box.max.x, box.max.y, box.max.z, 0.0f};
}

std::optional<double> first_hit_of_lane(const PreparedSphere& sphere, RTCRayN* ray, unsigned n, unsigned lane) {
    const Imath::V3f origin(RTCRayN_org_x(ray, n, lane), RTCRayN_org_y(ray, n, lane), RTCRayN_org_z(ray, n, lane));
    const Imath::V3f direction(RTCRayN_dir_x(ray, n, lane), RTCRayN_dir_y(ray, n, lane), RTCRayN_dir_z(ray, n, lane));
    return first_hit(sphere, origin, direction, RTCRayN_tnear(ray, n, lane), RTCRayN_tfar(ray, n, lane));
}

void sphere_intersect(const RTCIntersectFunctionNArguments* args) {
    const auto& sphere = *static_cast<const PreparedSphere*>(args->geometryUserPtr);
    RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, args->N);
    RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, args->N);
    for (unsigned lane = 0; lane < args->N; ++lane) {
        if (args->valid[lane] == 0) continue;
        const auto t = first_hit_of_lane(sphere, ray, args->N, lane);
        if (!t) continue;
        RTCRayN_tfar(ray, args->N, lane) = static_cast<float>(*t);
        RTCHitN_u(hit, args->N, lane) = 0.0f;
        RTCHitN_v(hit, args->N, lane) = 0.0f;
        RTCHitN_geomID(hit, args->N, lane) = args->geomID;
        RTCHitN_primID(hit, args->N, lane) = args->primID;
    }
}

void sphere_occluded(const RTCOccludedFunctionNArguments* args) {
    const auto& sphere = *static_cast<const PreparedSphere*>(args->geometryUserPtr);
    for (unsigned lane = 0; lane < args->N; ++lane) {
        if (args->valid[lane] == 0) continue;
        if (first_hit_of_lane(sphere, args->ray, args->N, lane)) {
            RTCRayN_tfar(args->ray, args->N, lane) = -std::numeric_limits<float>::infinity();
        }
    }
}

// --- Building ---------------------------------------------------------------------------------------------------------

RTCGeometry make_geometry(RTCDevice device, const TriangleMesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree may read 16 bytes at the last vertex, so it gets a copy of its own with room behind.
    auto* positions = static_cast<Imath::V3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Imath::V3f), mesh.position.size()));
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangle.data(), 0,
                               sizeof(mesh.triangle[0]), mesh.triangle.size());
    if (positions != nullptr) std::copy(mesh.position.begin(), mesh.position.end(), positions);
    return geometry;
}

RTCGeometry make_geometry(RTCDevice device, PreparedSphere& sphere) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryUserData(geometry, &sphere);
    rtcSetGeometryBoundsFunction(geometry, sphere_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, sphere_intersect);
    rtcSetGeometryOccludedFunction(geometry, sphere_occluded);
    return geometry;
}

int widest_native_packet(RTCDevice device) {
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) return 16;
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0) return 8;
    return 4;
}

// --- Packets ----------------------------------------------------------------------------------------------------------

/// Fills the lanes of a packet; those past the end of `rays` repeat the last ray and are switched off.
template <int Width, class Packet>
void fill(Packet& packet, int* valid, std::span<const Ray> rays) noexcept {
    for (std::size_t lane = 0; lane < Width; ++lane) {
        valid[lane] = lane < rays.size() ? -1 : 0;
        const Ray& ray = rays[std::min(lane, rays.size() - 1)];
        packet.org_x[lane] = ray.origin.x;
        packet.org_y[lane] = ray.origin.y;
        packet.org_z[lane] = ray.origin.z;
        packet.tnear[lane] = 0.0f;
        packet.dir_x[lane] = ray.direction.x;
        packet.dir_y[lane] = ray.direction.y;
        packet.dir_z[lane] = ray.direction.z;
        packet.time[lane] = 0.0f;
        packet.tfar[lane] = ray.t_max;
        packet.mask[lane] = ~0u;
        packet.id[lane] = 0;
        packet.flags[lane] = 0;
    }
}

template <int Width>
void intersect_packets(RTCScene scene, std::span<const Ray> rays, std::span<Hit> hits) noexcept {
    typename EmbreePacket<Width>::RayHit packet;
    alignas(4 * Width) int valid[Width];
    for (std::size_t begin = 0; begin < rays.size(); begin += Width) {
        const auto chunk = rays.subspan(begin, std::min<std::size_t>(Width, rays.size() - begin));
        fill<Width>(packet.ray, valid, chunk);
        for (std::size_t lane = 0; lane < Width; ++lane) {
            packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
            packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
        }
        embree_intersect<Width>(valid, scene, packet);
        for (std::size_t lane = 0; lane < chunk.size(); ++lane) {
            hits[begin + lane] = {packet.ray.tfar[lane], packet.hit.u[lane], packet.hit.v[lane],
                                  packet.hit.geomID[lane], packet.hit.primID[lane]};
        }
    }
}

template <int Width>
void occluded_packets(RTCScene scene, std::span<const Ray> rays, std::span<std::uint8_t> occluded) noexcept {
    typename EmbreePacket<Width>::Ray packet;
    alignas(4 * Width) int valid[Width];
    for (std::size_t begin = 0; begin < rays.size(); begin += Width) {
        const auto chunk = rays.subspan(begin, std::min<std::size_t>(Width, rays.size() - begin));
        fill<Width>(packet, valid, chunk);
        embree_occluded<Width>(valid, scene, packet);
        // Embree marks an occluded ray by setting its end to minus infinity.
        for (std::size_t lane = 0; lane < chunk.size(); ++lane) occluded[begin + lane] = packet.tfar[lane] < 0.0f;
    }
}

static_assert(Hit::kNone == RTC_INVALID_GEOMETRY_ID);

/// Embree takes coordinates up to about 1.8e18.
constexpr float kMostCoordinate = 1e18f;

}  // namespace

Accelerator::Accelerator(const std::vector<Shape>& shapes, int threads) : embree_(std::make_unique<Embree>()) {
    embree_->device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    if (embree_->device == nullptr) throw std::runtime_error("Embree failed: no device for this processor");
    embree_->packet_width = widest_native_packet(embree_->device);

    // Robust: rays that pass through a shared edge of two triangles meet one of them.
    embree_->scene = rtcNewScene(embree_->device);
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(embree_->scene, RTC_BUILD_QUALITY_HIGH);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        RTCGeometry geometry = nullptr;
        if (const auto* mesh = std::get_if<TriangleMesh>(&shapes[i].geometry)) {
            geometry = make_geometry(embree_->device, *mesh);
        } else {
            embree_->spheres.push_back(std::make_unique<PreparedSphere>(std::get<Sphere>(shapes[i].geometry)));
            geometry = make_geometry(embree_->device, *embree_->spheres.back());
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(embree_->scene, geometry, static_cast<unsigned>(i));
        rtcReleaseGeometry(geometry);
    }
    embree_->check("taking the shapes");
    rtcCommitScene(embree_->scene);
    embree_->check("building the hierarchy");

    if (shapes.empty()) return;
    RTCBounds box{};
    rtcGetSceneBounds(embree_->scene, &box);
    const Imath::V3f low(box.lower_x, box.lower_y, box.lower_z), high(box.upper_x, box.upper_y, box.upper_z);
    bounds_radius_ = (high - low).length() * 0.5f;
    // Embree leaves out shapes that it cannot hold, without a word, and then has no bounds.
    if (!(bounds_radius_ < kMostCoordinate))
        throw std::runtime_error("the scene's coordinates are too large for Embree");
}

Accelerator::~Accelerator() = default;

void Accelerator::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
    if (log_ != nullptr) log_->batches.push_back({{rays.begin(), rays.end()}, RayLog::Batch::Query::intersect});
    switch (embree_->packet_width) {
        case 16:
            return intersect_packets<16>(embree_->scene, rays, hits);
        case 8:
            return intersect_packets<8>(embree_->scene, rays, hits);
        default:
            return intersect_packets<4>(embree_->scene, rays, hits);
    }
}

void Accelerator::occluded(std::span<const Ray> rays, std::span<std::uint8_t> occluded) const {
    if (log_ != nullptr) log_->batches.push_back({{rays.begin(), rays.end()}, RayLog::Batch::Query::occluded});
    switch (embree_->packet_width) {
        case 16:
            return occluded_packets<16>(embree_->scene, rays, occluded);
        case 8:
            return occluded_packets<8>(embree_->scene, rays, occluded);
        default:
            return occluded_packets<4>(embree_->scene, rays, occluded);
    }
}

}  // namespace emulsion
