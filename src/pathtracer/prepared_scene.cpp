#include "pathtracer/prepared_scene.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "spectrum/colorimetry.h"

namespace emulsion {

namespace {

constexpr double kPi = std::numbers::pi;

/// Photometric strength of a light's spectrum: lm/683 in whatever it is per.
double strength(const ScaledSpectrum& spectrum) { return photometric_integral(spectrum.spectrum) * spectrum.scale; }

}  // namespace

std::vector<double> LightPowers::weights() const {
    const double total = std::accumulate(emitter.begin(), emitter.end(), 0.0);
    std::vector<double> weights(emitter.size());
    std::size_t begin = 0;
    for (const std::size_t end : light_end) {
        const auto first = emitter.begin() + static_cast<std::ptrdiff_t>(begin);
        const double of_light = std::accumulate(first, emitter.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
        const double equal_share = 1.0 / static_cast<double>(light_end.size());
        for (std::size_t i = begin; i < end; ++i) {
            const double within_light = of_light > 0.0 ? emitter[i] / of_light : 1.0 / static_cast<double>(end - begin);
            weights[i] = within_light * 0.5 * (equal_share + (total > 0.0 ? of_light / total : equal_share));
        }
        begin = end;
    }
    return weights;
}

PreparedScene::PreparedScene(Scene scene, int threads)
    : scene_(std::move(scene)), accelerator_(std::make_unique<Accelerator>(scene_.shapes, threads)) {
    for (const Material& material : scene_.materials) {
        material_reflectance_.push_back(add_spectrum(std::get<DiffuseMaterial>(material).reflectance, 1.0));
    }

    LightPowers powers;
    shapes_.reserve(scene_.shapes.size());
    for (const Shape& shape : scene_.shapes) add_shape(shape, powers);
    for (const Light& light : scene_.lights) add_light(light, powers);
    if (emitters_.empty()) return;
    const std::vector<double> weights = powers.weights();
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        emitters_[i].selection_probability = static_cast<float>(weights[i] / total);
    }
    picker_ = EmitterPicker(weights);
}

std::uint32_t PreparedScene::add_spectrum(const Spectrum& spectrum, double scale) {
    spectra_.emplace_back(spectrum, scale);
    return static_cast<std::uint32_t>(spectra_.size() - 1);
}

void PreparedScene::add_shape(const Shape& shape, LightPowers& powers) {
    PreparedShape prepared;
    prepared.reflectance = material_reflectance_.at(static_cast<std::size_t>(shape.material));
    prepared.mesh = std::get_if<TriangleMesh>(&shape.geometry);
    if (prepared.mesh == nullptr) {
        prepared.sphere = std::make_unique<PreparedSphere>(std::get<Sphere>(shape.geometry));
    }
    if (shape.area_light) {
        const AreaLight& light = *shape.area_light;
        const std::uint32_t radiance = add_spectrum(light.radiance.spectrum, light.radiance.scale);
        const double exitance = kPi * strength(light.radiance) * (light.two_sided ? 2.0 : 1.0);
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

void PreparedScene::add_light(const Light& light, LightPowers& powers) {
    const double scene_radius = std::max(static_cast<double>(accelerator_->bounds_radius()), 1e-30);
    const double scene_disk = kPi * scene_radius * scene_radius;
    if (const auto* point = std::get_if<PointLight>(&light)) {
        const std::uint32_t spectrum = add_spectrum(point->intensity.spectrum, point->intensity.scale);
        emitters_.push_back({PointEmitter{Imath::V3f(point->position)}, spectrum});
        powers.emitter.push_back(4.0 * kPi * strength(point->intensity));
    } else if (const auto* distant = std::get_if<DistantLight>(&light)) {
        const std::uint32_t spectrum = add_spectrum(distant->irradiance.spectrum, distant->irradiance.scale);
        emitters_.push_back({DistantEmitter{Imath::V3f(distant->to_light)}, spectrum});
        powers.emitter.push_back(scene_disk * strength(distant->irradiance));
    } else if (const auto* infinite = std::get_if<UniformInfiniteLight>(&light)) {
        infinite_emitters_.push_back(static_cast<std::uint32_t>(emitters_.size()));
        const std::uint32_t spectrum = add_spectrum(infinite->radiance.spectrum, infinite->radiance.scale);
        emitters_.push_back({InfiniteEmitter{}, spectrum});
        powers.emitter.push_back(4.0 * kPi * scene_disk * strength(infinite->radiance));
    }
    powers.light_end.push_back(emitters_.size());
}

}  // namespace emulsion
