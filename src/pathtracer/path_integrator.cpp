#include "pathtracer/path_integrator.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "pathtracer/light_sampling.h"
#include "pathtracer/surface_coordinates.h"
#include "pathtracer/vector_math.h"

namespace emulsion {

namespace {

constexpr float kInvPi = std::numbers::inv_pi_v<float>;

}  // namespace

template <class Transport>
void PathIntegrator<Transport>::trace(std::span<PathT> paths, std::span<FirstHit> first_hits) {
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

template <class Transport>
void PathIntegrator<Transport>::add_background(PathT& path) const noexcept {
    for (const std::uint32_t i : scene_.infinite_emitters()) {
        const Emitter& emitter = scene_.emitters()[i];
        float weight = 1.0f;
        if (path.direction_pdf > 0.0f) {
            const float pdf = direction_pdf(emitter.geometry, path.last_vertex, path.ray.direction, {}, {});
            weight = power_heuristic(path.direction_pdf, emitter.selection_probability * pdf);
        }
        path.radiance += path.throughput * emitted_towards(scene_, emitter, path.ray.direction, path.index) * weight;
    }
}

/// Adds the light that the path has met, sends a shadow ray, and draws the next direction.
/// Returns whether the path goes on.
template <class Transport>
bool PathIntegrator<Transport>::scatter(PathT& path, std::uint32_t path_index, const Hit& hit, int depth) {
    const auto& shape = scene_.shape(hit.shape);
    const SurfacePoint point = surface_point(scene_, path.ray, hit);
    if (shape.first_emitter) {
        add_emission(path, scene_.emitters()[*shape.first_emitter + hit.primitive], point, shape.two_sided);
    }
    if (depth == max_depth_) return false;
    path.last_vertex = point.position;

    Values reflectance;
    if (shape.diffuse_table) [[likely]] {
        reflectance = scene_.spectra()[*shape.diffuse_table].at(path.index);
    } else {
        const TexturePoint place{point.position, surface_uv(scene_, hit, point)};
        const PreparedMaterial& material =
            scene_.materials().at(shape.material, place, [&path] { return path.samples.next_1d(); });
        const auto* diffuse = std::get_if<PreparedDiffuse>(&material);
        if (diffuse == nullptr) return scatter_material(path, path_index, material, {hit, point, place}, depth);
        reflectance = scene_.materials().reflectance(*diffuse, place, path.index);
    }

    // Both sides of a diffuse surface reflect, each on its own side.
    const bool front = path.ray.direction.dot(point.shading_normal) < 0.0f;
    const Imath::V3f facing_normal = front ? point.shading_normal : -point.shading_normal;
    sample_light(path, path_index, point, [&](const Imath::V3f& wi) -> BsdfValue<Transport::kChannels> {
        const float pdf = std::max(wi.dot(facing_normal), 0.0f) * kInvPi;
        return {reflectance * pdf, pdf};
    });

    // The cosine in the density cancels that of the reflected radiance: what is left is the reflectance.
    const Imath::V3f local = cosine_hemisphere(path.samples.next_2d());
    const Imath::V3f direction = Frame(facing_normal).to_world(local);
    path.throughput *= reflectance;
    if (!(local.z > 0.0f)) return false;
    path.direction_pdf = local.z * kInvPi;
    path.ray.origin = point.origin_towards(direction);
    path.ray.direction = direction;
    return survives_roulette(path, depth);
}

template <class Transport>
void PathIntegrator<Transport>::add_emission(PathT& path, const Emitter& emitter, const SurfacePoint& point,
                                             bool two_sided) const noexcept {
    if (!two_sided && path.ray.direction.dot(point.geometric_normal) >= 0.0f) return;
    float weight = 1.0f;
    if (path.direction_pdf > 0.0f) {
        const float pdf = direction_pdf(emitter.geometry, path.last_vertex, path.ray.direction, point.position,
                                        point.geometric_normal);
        weight = power_heuristic(path.direction_pdf, emitter.selection_probability * pdf);
    }
    path.radiance += path.throughput * scene_.spectra()[emitter.spectrum].at(path.index) * (weight * emitter.scale);
}

template <class Transport>
void PathIntegrator<Transport>::trace_shadow_rays(std::span<PathT> paths) {
    occluded_.resize(shadow_rays_.size());
    if (!shadow_rays_.empty()) scene_.accelerator().occluded(shadow_rays_, occluded_);
    for (std::size_t i = 0; i < shadows_.size(); ++i) {
        if (occluded_[i] == 0) paths[shadows_[i].path].radiance += shadows_[i].radiance;
    }
    shadow_rays_.clear();
    shadows_.clear();
}

#define EMULSION_INSTANTIATE(TRANSPORT) template class PathIntegrator<TRANSPORT>;
EMULSION_FOR_EACH_TRANSPORT(EMULSION_INSTANTIATE)

}  // namespace emulsion
