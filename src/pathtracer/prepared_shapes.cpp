// What shading and light sampling need to know of the shapes.
#include <cmath>
#include <numbers>
#include <utility>

#include "pathtracer/bilinear.h"
#include "pathtracer/prepared_scene.h"

namespace emulsion {

namespace {

constexpr double kPi = std::numbers::pi;

template <class Quadric>
std::unique_ptr<PreparedQuadric> prepared_copy(const Quadric& quadric) {
    return std::make_unique<PreparedQuadric>(prepared(quadric));
}

/// Area in world space, of a quadric that the map bends roughly: that of one which keeps its volume. Good enough to
/// pick by.
double area_to_pick_by(const PreparedQuadric& quadric) {
    return std::visit(
        [](const auto& q) {
            const double scale = std::cbrt(std::abs(q.world_from_object.determinant()));
            return q.object_area * scale * scale;
        },
        quadric);
}

/// The side that pbrt-v4 samples is not turned by a mirroring map, whatever its rays find: see scene_shapes.h.
void light_the_sampled_side(PreparedQuadric& quadric) {
    std::visit(
        [](auto& q) {
            if (q.world_from_object.determinant() < 0.0) q.flip_normal = !q.flip_normal;
        },
        quadric);
}

}  // namespace

void PreparedScene::add_shape(const Shape& shape, LightPowers& powers) {
    PreparedShape prepared_shape;
    prepared_shape.material = static_cast<std::uint32_t>(shape.material);
    prepared_shape.diffuse_table = materials_->constant_diffuse(prepared_shape.material);
    prepared_shape.mesh = std::get_if<TriangleMesh>(&shape.geometry);
    prepared_shape.patches = std::get_if<BilinearMesh>(&shape.geometry);
    if (const auto* const sphere = std::get_if<Sphere>(&shape.geometry))
        prepared_shape.quadric = prepared_copy(*sphere);
    if (const auto* const disk = std::get_if<Disk>(&shape.geometry)) prepared_shape.quadric = prepared_copy(*disk);
    if (const auto* const cylinder = std::get_if<Cylinder>(&shape.geometry)) {
        prepared_shape.quadric = prepared_copy(*cylinder);
    }
    shapes_.push_back(std::move(prepared_shape));
    if (shape.area_light) add_area_light(*shape.area_light, shapes_.back(), powers);
}

void PreparedScene::add_area_light(const AreaLight& light, PreparedShape& shape, LightPowers& powers) {
    const std::uint32_t radiance = spectra_.add_light(light.radiance);
    const double exitance = kPi * photometric_strength(light.radiance) * (light.two_sided ? 2.0 : 1.0);
    const auto scale_of = [&](std::uint32_t i) {
        return light.triangle_scale.empty() ? 1.0f : light.triangle_scale.at(i);
    };
    const auto add = [&](const EmitterGeometry& geometry, std::uint32_t i, double area) {
        emitters_.push_back({geometry, radiance, scale_of(i)});
        powers.emitter.push_back(exitance * static_cast<double>(scale_of(i)) * area);
    };
    shape.first_emitter = static_cast<std::uint32_t>(emitters_.size());
    shape.two_sided = light.two_sided;
    if (shape.mesh != nullptr) {
        for (std::uint32_t i = 0; i < shape.mesh->triangle.size(); ++i) {
            TriangleEmitter emitter = emitter_of(*shape.mesh, i);
            emitter.two_sided = light.two_sided;
            add(emitter, i, emitter.face.area);
        }
    } else if (shape.patches != nullptr) {
        for (std::uint32_t i = 0; i < shape.patches->patch.size(); ++i) {
            add(PatchEmitter{shape.patches, i, light.two_sided}, i, area_of(BilinearPatch(*shape.patches, i)));
        }
    } else {
        light_the_sampled_side(*shape.quadric);
        add(QuadricEmitter{shape.quadric.get(), light.two_sided}, 0, area_to_pick_by(*shape.quadric));
    }
    powers.light_end.push_back(emitters_.size());
}

// --- Hits

namespace {

SurfacePoint point_of_shape(const PreparedScene::PreparedShape& shape, const Ray& ray, const Hit& hit) noexcept {
    if (shape.mesh != nullptr) return surface_point(*shape.mesh, hit);
    if (shape.patches != nullptr) return surface_point(*shape.patches, hit);
    const Imath::V3d along = Imath::V3d(ray.origin) + static_cast<double>(hit.t) * Imath::V3d(ray.direction);
    return surface_point(point_at(*shape.quadric, along));
}

}  // namespace

SurfacePoint surface_point_elsewhere(const PreparedScene& scene, const Ray& ray, const Hit& hit) noexcept {
    const auto& shape = scene.shape(hit.shape);
    if (hit.instance == Hit::kNone) return point_of_shape(shape, ray, hit);
    const PreparedInstance& instance = scene.instance(hit.instance);
    return world_point(instance, point_of_shape(shape, object_ray(instance, ray), hit));
}

}  // namespace emulsion
