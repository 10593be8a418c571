#include "pathtracer/path_integrator.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "pathtracer/vector_math.h"

namespace emulsion {

namespace {

constexpr float kInvPi = std::numbers::inv_pi_v<float>;

/// Scattering events that every path is granted before Russian roulette may end it.
constexpr int kFirstRouletteDepth = 2;

/// Shadow rays stop short of the light by this share of the distance, beside the offsets at both ends.
constexpr float kShadowRayEnd = 1.0f - 1e-5f;

}  // namespace

template <int N>
void PathIntegrator<N>::trace(std::span<Path<N>> paths, std::span<FirstHit> first_hits) {
    active_.resize(paths.size());
    std::iota(active_.begin(), active_.end(), 0u);
    for (int depth = 0; !active_.empty(); ++depth) {
        rays_.resize(active_.size());
        hits_.resize(active_.size());
        for (std::size_t i = 0; i < active_.size(); ++i) rays_[i] = paths[active_[i]].ray;
        scene_.accelerator().intersect(rays_, hits_);
        if (depth == 0 && !first_hits.empty()) note_first_hits(scene_, rays_, hits_, first_hits);

        // The paths that go on move up; their order stays, and with it their neighbourhood.
        std::size_t going_on = 0;
        for (std::size_t i = 0; i < active_.size(); ++i) {
            const std::uint32_t path = active_[i];
            if (hits_[i].shape == Hit::kNone) {
                add_background(paths[path]);
            } else if (scatter(paths[path], path, hits_[i], depth)) {
                active_[going_on++] = path;
            }
        }
        active_.resize(going_on);
        trace_shadow_rays(paths);
    }
}

template <int N>
void PathIntegrator<N>::add_background(Path<N>& path) const noexcept {
    for (const std::uint32_t i : scene_.infinite_emitters()) {
        const Emitter& emitter = scene_.emitters()[i];
        float weight = 1.0f;
        if (path.direction_pdf > 0.0f) {
            weight = power_heuristic(path.direction_pdf, emitter.selection_probability * kInfiniteEmitterPdf);
        }
        path.radiance += path.throughput * scene_.spectrum(emitter.spectrum).at(path.index) * weight;
    }
}

/// Adds the light that the path has met, sends a shadow ray, and draws the next direction.
/// Returns whether the path goes on.
template <int N>
bool PathIntegrator<N>::scatter(Path<N>& path, std::uint32_t path_index, const Hit& hit, int depth) {
    const auto& shape = scene_.shape(hit.shape);
    const SurfacePoint point = surface_point(scene_, path.ray, hit);
    if (shape.first_emitter) {
        add_emission(path, scene_.emitters()[*shape.first_emitter + hit.primitive], point, shape.two_sided);
    }
    if (depth == max_depth_) return false;

    // Both sides of a diffuse surface reflect, each on its own side.
    const SampledSpectrum<N> reflectance = scene_.spectrum(shape.reflectance).at(path.index);
    const bool front = path.ray.direction.dot(point.shading_normal) < 0.0f;
    const Imath::V3f facing_normal = front ? point.shading_normal : -point.shading_normal;
    path.last_vertex = point.position;
    sample_light(path, path_index, point, reflectance, facing_normal);

    // The cosine in the density cancels that of the reflected radiance: what is left is the reflectance.
    const Imath::V3f local = cosine_hemisphere(path.samples.next_2d());
    const Imath::V3f direction = Frame(facing_normal).to_world(local);
    path.throughput *= reflectance;
    float largest = path.throughput.max();
    if (!(local.z > 0.0f) || !(largest > 0.0f)) return false;
    path.direction_pdf = local.z * kInvPi;
    path.ray.origin = point.origin_towards(direction);
    path.ray.direction = direction;

    if (depth + 1 < kFirstRouletteDepth || largest >= 1.0f) return true;
    if (path.samples.next_1d() >= largest) return false;
    path.throughput *= 1.0f / largest;
    return true;
}

template <int N>
void PathIntegrator<N>::add_emission(Path<N>& path, const Emitter& emitter, const SurfacePoint& point,
                                     bool two_sided) const noexcept {
    if (!two_sided && path.ray.direction.dot(point.geometric_normal) >= 0.0f) return;
    float weight = 1.0f;
    if (path.direction_pdf > 0.0f) {
        const float pdf = direction_pdf(emitter.geometry, path.last_vertex, path.ray.direction, point.position,
                                        point.geometric_normal);
        weight = power_heuristic(path.direction_pdf, emitter.selection_probability * pdf);
    }
    path.radiance += path.throughput * scene_.spectrum(emitter.spectrum).at(path.index) * (weight * emitter.scale);
}

template <int N>
void PathIntegrator<N>::sample_light(Path<N>& path, std::uint32_t path_index, const SurfacePoint& point,
                                     const SampledSpectrum<N>& reflectance, const Imath::V3f& facing_normal) {
    if (scene_.emitters().empty()) return;
    const Emitter& emitter = scene_.emitters()[scene_.picker().pick(path.samples.next_1d_fine())];
    const EmitterSample light = sample(emitter.geometry, path.last_vertex, path.samples.next_2d());
    const float cosine = light.to_light.dot(facing_normal);
    if (light.scale == 0.0f || !(cosine > 0.0f)) return;

    // Lights without extent are found in this way alone; the others also by chance, and share the weight.
    const float selection = emitter.selection_probability;
    float factor = light.scale * emitter.scale * cosine * kInvPi / selection;
    if (light.pdf > 0.0f) factor *= power_heuristic(selection * light.pdf, cosine * kInvPi) / light.pdf;
    const SampledSpectrum<N> radiance =
        path.throughput * reflectance * scene_.spectrum(emitter.spectrum).at(path.index) * factor;
    if (!(radiance.max() > 0.0f)) return;

    const Imath::V3f origin = point.origin_towards(light.to_light);
    if (light.infinite) {
        shadow_rays_.push_back({origin, light.to_light});
    } else {
        shadow_rays_.push_back({origin, light.target - origin, kShadowRayEnd});
    }
    shadows_.push_back({radiance, path_index});
}

template <int N>
void PathIntegrator<N>::trace_shadow_rays(std::span<Path<N>> paths) {
    occluded_.resize(shadow_rays_.size());
    if (!shadow_rays_.empty()) scene_.accelerator().occluded(shadow_rays_, occluded_);
    for (std::size_t i = 0; i < shadows_.size(); ++i) {
        if (occluded_[i] == 0) paths[shadows_[i].path].radiance += shadows_[i].radiance;
    }
    shadow_rays_.clear();
    shadows_.clear();
}

template class PathIntegrator<1>;
template class PathIntegrator<2>;
template class PathIntegrator<4>;
template class PathIntegrator<8>;
template class PathIntegrator<16>;
template class PathIntegrator<32>;

}  // namespace emulsion
