// Lights without a shape, as emitters.
#include <algorithm>
#include <numbers>

#include "pathtracer/prepared_scene.h"

namespace emulsion {

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

void PreparedScene::add_light(const Light& light, LightPowers& powers) {
    const double scene_radius = std::max(static_cast<double>(accelerator_->bounds_radius()), 1e-30);
    const double scene_disk = kPi * scene_radius * scene_radius;
    if (const auto* point = std::get_if<PointLight>(&light)) {
        const std::uint32_t spectrum = spectra_.add_light(point->intensity);
        emitters_.push_back({PointEmitter{Imath::V3f(point->position)}, spectrum});
        powers.emitter.push_back(4.0 * kPi * photometric_strength(point->intensity));
    } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
        const std::uint32_t spectrum = spectra_.add_light(spot->intensity);
        const Imath::M44f m(spot->light_from_world);
        const Imath::M33f light_from_world(m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1],
                                           m[2][2]);
        emitters_.push_back({SpotEmitter{Imath::V3f(spot->position), light_from_world,
                                         static_cast<float>(spot->cos_full), static_cast<float>(spot->cos_none)},
                             spectrum});
        powers.emitter.push_back(spot_solid_angle(spot->cos_full, spot->cos_none) *
                                 photometric_strength(spot->intensity));
    } else if (const auto* distant = std::get_if<DistantLight>(&light)) {
        const std::uint32_t spectrum = spectra_.add_light(distant->irradiance);
        emitters_.push_back({DistantEmitter{Imath::V3f(distant->to_light)}, spectrum});
        powers.emitter.push_back(scene_disk * photometric_strength(distant->irradiance));
    } else if (const auto* infinite = std::get_if<UniformInfiniteLight>(&light)) {
        infinite_emitters_.push_back(static_cast<std::uint32_t>(emitters_.size()));
        const std::uint32_t spectrum = spectra_.add_light(infinite->radiance);
        emitters_.push_back({InfiniteEmitter{}, spectrum});
        powers.emitter.push_back(4.0 * kPi * scene_disk * photometric_strength(infinite->radiance));
    } else if (const auto* image = std::get_if<ImageInfiniteLight>(&light)) {
        infinite_emitters_.push_back(static_cast<std::uint32_t>(emitters_.size()));
        const std::uint32_t spectrum = spectra_.add_light(image->illuminant);
        environment_maps_.push_back(std::make_unique<EnvironmentMap>(*image));
        emitters_.push_back({ImageEmitter{environment_maps_.back().get()}, spectrum});
        powers.emitter.push_back(4.0 * kPi * scene_disk * photometric_strength(image->illuminant) *
                                 mean_luminance(*image->texels, image->space));
    }
    powers.light_end.push_back(emitters_.size());
}

}  // namespace emulsion
