// What shading and light sampling need to know of the shapes.
#include <cmath>
#include <numbers>
#include <utility>

#include "pathtracer/prepared_scene.h"

namespace emulsion {

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

void PreparedScene::add_shape(const Shape& shape, LightPowers& powers) {
    PreparedShape prepared;
    prepared.material = static_cast<std::uint32_t>(shape.material);
    prepared.diffuse_table = materials_->constant_diffuse(prepared.material);
    prepared.mesh = std::get_if<TriangleMesh>(&shape.geometry);
    if (prepared.mesh == nullptr) {
        prepared.sphere = std::make_unique<PreparedSphere>(std::get<Sphere>(shape.geometry));
    }
    if (shape.area_light) {
        const AreaLight& light = *shape.area_light;
        const std::uint32_t radiance = spectra_.add_light(light.radiance);
        const double exitance = kPi * photometric_strength(light.radiance) * (light.two_sided ? 2.0 : 1.0);
        prepared.first_emitter = static_cast<std::uint32_t>(emitters_.size());
        prepared.two_sided = light.two_sided;
        if (prepared.mesh != nullptr) {
            for (std::uint32_t i = 0; i < prepared.mesh->triangle.size(); ++i) {
                const TriangleGeometry triangle(*prepared.mesh, i);
                const float scale = light.triangle_scale.empty() ? 1.0f : light.triangle_scale.at(i);
                emitters_.push_back({TriangleEmitter{triangle, light.two_sided}, radiance, scale});
                powers.emitter.push_back(exitance * static_cast<double>(scale) * static_cast<double>(triangle.area));
            }
        } else {
            // Of an ellipsoid, the area of the sphere of the same volume: good enough to pick by.
            const PreparedSphere& sphere = *prepared.sphere;
            const double volume_scale = std::abs(sphere.world_from_object.determinant());
            const double radius = sphere.radius * std::cbrt(volume_scale);
            emitters_.push_back({SphereEmitter{sphere, light.two_sided}, radiance});
            powers.emitter.push_back(exitance * 4.0 * kPi * radius * radius);
        }
        powers.light_end.push_back(emitters_.size());
    }
    shapes_.push_back(std::move(prepared));
}

}  // namespace emulsion
