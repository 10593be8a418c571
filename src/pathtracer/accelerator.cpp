#include "pathtracer/accelerator.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "pathtracer/bilinear.h"
#include "pathtracer/embree.h"
#include "pathtracer/quadrics.h"

namespace emulsion {

struct Accelerator::Embree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    int packet_width = 4;
    std::vector<RTCScene> objects;
    std::vector<std::unique_ptr<PreparedQuadric>> quadrics;  // Embree keeps their addresses
    // Geometry numbers of the top level: shapes outside of objects in their order, then the instances.
    std::vector<std::uint32_t> shape_of_geometry;
    std::vector<std::size_t> first_shape_of_instance;

    Embree() = default;
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    ~Embree() {
        if (scene != nullptr) rtcReleaseScene(scene);
        for (RTCScene object : objects) rtcReleaseScene(object);
        if (device != nullptr) rtcReleaseDevice(device);
    }

    void check(const char* step) const {
        const RTCError error = rtcGetDeviceError(device);
        if (error != RTC_ERROR_NONE) {
            throw std::runtime_error(std::string("Embree failed while ") + step + ": error code " +
                                     std::to_string(static_cast<int>(error)));
        }
    }
    [[nodiscard]] RTCScene new_scene(RTCSceneFlags size) const;
    void attach(RTCScene to, RTCGeometry geometry, std::size_t number) const;
    [[nodiscard]] RTCGeometry make_geometry(const TriangleMesh& mesh) const;
    [[nodiscard]] RTCGeometry make_geometry(const BilinearMesh& mesh) const;
    template <class Quadric>
    requires requires(const Quadric& quadric) { prepared(quadric); }
    [[nodiscard]] RTCGeometry make_geometry(const Quadric& quadric);
    [[nodiscard]] RTCGeometry make_instance(const ObjectInstance& instance) const;

    /// Turns Embree's numbers into ours.
    [[nodiscard]] Hit hit_of(float t, float u, float v, unsigned geometry, unsigned primitive,
                             unsigned instance) const noexcept {
        if (geometry == RTC_INVALID_GEOMETRY_ID) return {};
        if (instance == RTC_INVALID_GEOMETRY_ID) return {t, u, v, shape_of_geometry[geometry], primitive, Hit::kNone};
        const auto number = static_cast<std::uint32_t>(instance - shape_of_geometry.size());
        return {t, u, v, static_cast<std::uint32_t>(first_shape_of_instance[number] + geometry), primitive, number};
    }
};

namespace {

// --- User geometry: a mesh of patches, or one quadric ----------------------------------------------------------------

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
RTCGeometry user_geometry(RTCDevice device, const Geometry& shape, std::size_t primitives) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(primitives));
    rtcSetGeometryUserData(geometry, const_cast<Geometry*>(&shape));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
    rtcSetGeometryBoundsFunction(geometry, bounds_callback<Geometry>, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect_callback<Geometry>);
    rtcSetGeometryOccludedFunction(geometry, occluded_callback<Geometry>);
    return geometry;
}

/// Gives the geometry the positions, without a copy if there is room behind: Embree may read 16 bytes at the last.
void set_positions(RTCGeometry geometry, const std::vector<Imath::V3f>& position) {
    if (position.capacity() > position.size()) {
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, position.data(), 0,
                                   sizeof(Imath::V3f), position.size());
        return;
    }
    auto* copy = static_cast<Imath::V3f*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Imath::V3f), position.size()));
    if (copy != nullptr) std::copy(position.begin(), position.end(), copy);
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

template <int Width, class HitOf>
void intersect_packets(RTCScene scene, std::span<const Ray> rays, std::span<Hit> hits, const HitOf& hit_of) noexcept {
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
            hits[begin + lane] = hit_of(packet.ray.tfar[lane], packet.hit.u[lane], packet.hit.v[lane],
                                        packet.hit.geomID[lane], packet.hit.primID[lane], packet.hit.instID[0][lane]);
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

/// Triangles of a scene from which on its hierarchies are compact: they take half of the memory, and a seventh more of
/// the rendering time (docs/geometry.md).
constexpr std::size_t kManyTriangles = 4'000'000;

RTCSceneFlags flags_by_size(const Scene& scene) {
    std::size_t triangles = 0;
    for (const Shape& shape : scene.shapes) {
        if (const auto* const mesh = std::get_if<TriangleMesh>(&shape.geometry)) triangles += mesh->triangle.size();
    }
    return triangles < kManyTriangles ? RTC_SCENE_FLAG_NONE : RTC_SCENE_FLAG_COMPACT;
}

}  // namespace

// --- Building ---------------------------------------------------------------------------------------------------------

RTCScene Accelerator::Embree::new_scene(RTCSceneFlags size) const {
    RTCScene made = rtcNewScene(device);
    // Robust: rays that pass through a shared edge of two triangles meet one of them.
    rtcSetSceneFlags(made, RTC_SCENE_FLAG_ROBUST | size);
    rtcSetSceneBuildQuality(made, RTC_BUILD_QUALITY_HIGH);
    return made;
}

void Accelerator::Embree::attach(RTCScene to, RTCGeometry geometry, std::size_t number) const {
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(to, geometry, static_cast<unsigned>(number));
    rtcReleaseGeometry(geometry);
}

RTCGeometry Accelerator::Embree::make_geometry(const TriangleMesh& mesh) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    set_positions(geometry, mesh.position);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangle.data(), 0,
                               sizeof(mesh.triangle[0]), mesh.triangle.size());
    return geometry;
}

RTCGeometry Accelerator::Embree::make_geometry(const BilinearMesh& mesh) const {
    if (!mesh.flat) return user_geometry(device, mesh, mesh.patch.size());
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_QUAD);
    set_positions(geometry, mesh.position);
    auto* walk = static_cast<std::array<std::uint32_t, 4>*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, sizeof(mesh.patch[0]), mesh.patch.size()));
    if (walk == nullptr) return geometry;
    for (const auto& [p00, p10, p01, p11] : mesh.patch) *walk++ = {p00, p10, p11, p01};
    return geometry;
}

template <class Quadric>
requires requires(const Quadric& quadric) { prepared(quadric); }
RTCGeometry Accelerator::Embree::make_geometry(const Quadric& quadric) {
    quadrics.push_back(std::make_unique<PreparedQuadric>(prepared(quadric)));
    return std::visit([&](const auto& shape) { return user_geometry(device, shape, 1); }, *quadrics.back());
}

RTCGeometry Accelerator::Embree::make_instance(const ObjectInstance& instance) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(geometry, objects[static_cast<std::size_t>(instance.object)]);
    std::array<float, 12> columns{};  // the images of x, y and z, and of the origin
    for (std::size_t i = 0; i < columns.size(); ++i) {
        columns[i] = static_cast<float>(instance.world_from_object.x[i / 3][i % 3]);
    }
    rtcSetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
    return geometry;
}

Accelerator::Accelerator(const Scene& scene, std::span<const ShapeRange> objects, int threads)
    : embree_(std::make_unique<Embree>()) {
    Embree& embree = *embree_;
    embree.device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    if (embree.device == nullptr) throw std::runtime_error("Embree failed: no device for this processor");
    embree.packet_width = widest_native_packet(embree.device);
    const RTCSceneFlags flags = flags_by_size(scene);
    embree.scene = embree.new_scene(flags);

    const auto geometry_of = [&](const Shape& shape) {
        return std::visit([&](const auto& geometry) { return embree.make_geometry(geometry); }, shape.geometry);
    };
    std::vector<bool> in_object(scene.shapes.size(), false);
    for (const ShapeRange& object : objects) {
        embree.objects.push_back(embree.new_scene(flags));
        for (std::size_t i = object.first; i < object.end; ++i) {
            in_object[i] = true;
            embree.attach(embree.objects.back(), geometry_of(scene.shapes[i]), i - object.first);
        }
        embree.check("taking the shapes of an object");
        rtcCommitScene(embree.objects.back());
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        if (in_object[i]) continue;
        embree.attach(embree.scene, geometry_of(scene.shapes[i]), embree.shape_of_geometry.size());
        embree.shape_of_geometry.push_back(static_cast<std::uint32_t>(i));
    }
    for (const ObjectInstance& instance : scene.instances) {
        const std::size_t number = embree.shape_of_geometry.size() + embree.first_shape_of_instance.size();
        embree.attach(embree.scene, embree.make_instance(instance), number);
        embree.first_shape_of_instance.push_back(objects[static_cast<std::size_t>(instance.object)].first);
    }
    embree.check("taking the shapes");
    rtcCommitScene(embree.scene);
    embree.check("building the hierarchy");

    if (embree.shape_of_geometry.empty() && embree.first_shape_of_instance.empty()) return;
    RTCBounds box{};
    rtcGetSceneBounds(embree.scene, &box);
    const Imath::V3f low(box.lower_x, box.lower_y, box.lower_z), high(box.upper_x, box.upper_y, box.upper_z);
    bounds_radius_ = (high - low).length() * 0.5f;
    // Embree leaves out shapes that it cannot hold, without a word, and then has no bounds.
    if (!(bounds_radius_ < kMostCoordinate))
        throw std::runtime_error("the scene's coordinates are too large for Embree");
}

Accelerator::~Accelerator() = default;

void Accelerator::intersect(std::span<const Ray> rays, std::span<Hit> hits) const {
    if (log_ != nullptr) log_->batches.push_back({{rays.begin(), rays.end()}, RayLog::Batch::Query::intersect});
    const auto hit_of = [&](auto... numbers) { return embree_->hit_of(numbers...); };
    switch (embree_->packet_width) {
        case 16:
            return intersect_packets<16>(embree_->scene, rays, hits, hit_of);
        case 8:
            return intersect_packets<8>(embree_->scene, rays, hits, hit_of);
        default:
            return intersect_packets<4>(embree_->scene, rays, hits, hit_of);
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
