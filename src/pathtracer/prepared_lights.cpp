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
    } else if (const auto* distant = std::get_if<DistantLight>(&light)) {
        const std::uint32_t spectrum = spectra_.add_light(distant->irradiance);
        emitters_.push_back({DistantEmitter{Imath::V3f(distant->to_light)}, spectrum});
        powers.emitter.push_back(scene_disk * photometric_strength(distant->irradiance));
    } else if (const auto* infinite = std::get_if<UniformInfiniteLight>(&light)) {
        infinite_emitters_.push_back(static_cast<std::uint32_t>(emitters_.size()));
        const std::uint32_t spectrum = spectra_.add_light(infinite->radiance);
        emitters_.push_back({InfiniteEmitter{}, spectrum});
        powers.emitter.push_back(4.0 * kPi * scene_disk * photometric_strength(infinite->radiance));
    }
    powers.light_end.push_back(emitters_.size());
}

}  // namespace emulsion
