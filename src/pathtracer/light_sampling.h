#pragma once
// The parts of PathIntegrator that diffuse surfaces and all others share: next-event estimation and Russian roulette.

#include "pathtracer/bsdf.h"
#include "pathtracer/environment_map.h"
#include "pathtracer/path_integrator.h"
#include "pathtracer/vector_math.h"

namespace emulsion {

/// Shadow rays stop short of the light by this share of the distance, beside the offsets at both ends.
inline constexpr float kShadowRayEnd = 1.0f - 1e-5f;

/// Scattering events that every path is granted before Russian roulette may end it.
inline constexpr int kFirstRouletteDepth = 2;

/// What an emitter sends from where the unit vector `to_light` points, but for its scale.
template <class Index>
[[nodiscard]] inline ValuesAt<Index> emitted_towards(const PreparedScene& scene, const Emitter& emitter,
                                                     const Imath::V3f& to_light, const Index& index) noexcept {
    ValuesAt<Index> values = scene.spectra()[emitter.spectrum].at(index);
    if (const auto* image = std::get_if<ImageEmitter>(&emitter.geometry)) {
        values *= image->map->colour(to_light, index);
    }
    return values;
}

/// `evaluate` gives the BsdfValue of a unit direction in world space.
template <class Transport>
template <class Evaluate>
void PathIntegrator<Transport>::sample_light(PathT& path, std::uint32_t path_index, const SurfacePoint& point,
                                             Evaluate&& evaluate) {
    if (scene_.emitters().empty()) return;
    const Emitter& emitter = scene_.emitters()[scene_.picker().pick(path.samples.next_1d_fine())];
    const EmitterSample light = sample(emitter.geometry, path.last_vertex, path.samples.next_2d());
    if (light.scale == 0.0f) return;
    const BsdfValue<Transport::kChannels> bsdf = evaluate(light.to_light);
    if (!(bsdf.pdf > 0.0f)) return;

    // Lights without extent are found in this way alone; the others also by chance, and share the weight:
    // power_heuristic(pdf, bsdf.pdf) / pdf, in fewer divisions.
    const float selection = emitter.selection_probability;
    const float pdf = selection * light.pdf, ratio = bsdf.pdf / pdf;
    const float weighted = light.pdf > 0.0f ? pdf * (1.0f + ratio * ratio) : selection;
    const float factor = light.scale * emitter.scale / weighted;
    const Values radiance =
        path.throughput * bsdf.f_cos * emitted_towards(scene_, emitter, light.to_light, path.index) * factor;
    if (!(radiance.max() > 0.0f)) return;

    const Imath::V3f origin = point.origin_towards(light.to_light);
    if (light.infinite) {
        shadow_rays_.push_back({origin, light.to_light});
    } else {
        shadow_rays_.push_back({origin, light.target - origin, kShadowRayEnd});
    }
    shadows_.push_back({radiance, path_index});
}

/// Ends paths that carry little, and makes up for it in those that go on.
template <class Transport>
inline bool PathIntegrator<Transport>::survives_roulette(PathT& path, int depth) noexcept {
    // Without what the medium's index does to radiance: it comes back when the path leaves the medium.
    const float largest = path.throughput.max() * path.eta_scale;
    if (!(largest > 0.0f)) return false;
    if (depth + 1 < kFirstRouletteDepth || largest >= 1.0f) return true;
    if (path.samples.next_1d() >= largest) return false;
    path.throughput *= 1.0f / largest;
    return true;
}

}  // namespace emulsion
