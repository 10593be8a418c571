#include "pathtracer/accelerator.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <variant>

#include "pathtracer/embree_packets.h"
#include "pathtracer/embree_user_geometry.h"
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
    [[nodiscard]] RTCScene new_scene(Hierarchy hierarchy) const;
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

static_assert(Hit::kNone == RTC_INVALID_GEOMETRY_ID);

/// Embree takes coordinates up to about 1.8e18.
constexpr float kMostCoordinate = 1e18f;

Hierarchy hierarchy_of(const Scene& scene, std::size_t many_triangles) {
    std::size_t triangles = 0;
    for (const Shape& shape : scene.shapes) {
        if (const auto* const mesh = std::get_if<TriangleMesh>(&shape.geometry)) triangles += mesh->triangle.size();
    }
    return triangles < many_triangles ? Hierarchy::fast : Hierarchy::compact;
}

}  // namespace

// --- Building ---------------------------------------------------------------------------------------------------------

RTCScene Accelerator::Embree::new_scene(Hierarchy hierarchy) const {
    RTCScene made = rtcNewScene(device);
    const RTCSceneFlags size = hierarchy == Hierarchy::compact ? RTC_SCENE_FLAG_COMPACT : RTC_SCENE_FLAG_NONE;
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
    if (!mesh.flat) return user_geometry(device, mesh);
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
    return user_geometry(device, *quadrics.back());
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

Accelerator::Accelerator(const Scene& scene, std::span<const ShapeRange> objects, int threads,
                         std::size_t many_triangles)
    : embree_(std::make_unique<Embree>()), hierarchy_(hierarchy_of(scene, many_triangles)) {
    Embree& embree = *embree_;
    embree.device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    if (embree.device == nullptr) throw std::runtime_error("Embree failed: no device for this processor");
    embree.packet_width = widest_native_packet(embree.device);
    embree.scene = embree.new_scene(hierarchy_);

    const auto geometry_of = [&](const Shape& shape) {
        return std::visit([&](const auto& geometry) { return embree.make_geometry(geometry); }, shape.geometry);
    };
    std::vector<bool> in_object(scene.shapes.size(), false);
    for (const ShapeRange& object : objects) {
        embree.objects.push_back(embree.new_scene(hierarchy_));
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
