#include "pathtracer/emitters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "pathtracer/environment_map.h"
#include "pathtracer/vector_math.h"

namespace emulsion {

namespace {

using Imath::V3f;

EmitterSample sample_one(const PointEmitter& emitter, const V3f& from, std::array<float, 2>) noexcept {
    const V3f to = emitter.position - from;
    const float distance2 = to.dot(to);
    EmitterSample sample;
    if (!(distance2 > 0.0f)) return sample;
    sample.to_light = to * (1.0f / std::sqrt(distance2));
    sample.target = emitter.position;
    sample.scale = 1.0f / distance2;
    return sample;
}

/// The share of the intensity that a spot light has in a direction away from it.
float spot_share(const SpotEmitter& emitter, const V3f& direction) noexcept {
    const V3f in_light = direction * emitter.light_from_world;
    const float cosine = in_light.z / in_light.length();
    if (cosine >= emitter.cos_full) return 1.0f;
    if (!(cosine > emitter.cos_none)) return 0.0f;
    const float t = (cosine - emitter.cos_none) / (emitter.cos_full - emitter.cos_none);
    return t * t * (3.0f - 2.0f * t);
}

EmitterSample sample_one(const SpotEmitter& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    EmitterSample sample = sample_one(PointEmitter{emitter.position}, from, u);
    if (sample.scale > 0.0f) sample.scale *= spot_share(emitter, -sample.to_light);
    return sample;
}

EmitterSample sample_one(const DistantEmitter& emitter, const V3f&, std::array<float, 2>) noexcept {
    return {emitter.to_light, V3f(0.0f), true, 0.0f, 1.0f};
}

EmitterSample sample_one(const InfiniteEmitter&, const V3f&, std::array<float, 2> u) noexcept {
    return {uniform_sphere(u), V3f(0.0f), true, kInfiniteEmitterPdf, 1.0f};
}

EmitterSample sample_one(const ImageEmitter& emitter, const V3f&, std::array<float, 2> u) noexcept {
    const V3f to_light = emitter.map->sample(u);
    // Of the direction as it is after rounding: another texel's, now and then, as its radiance will be.
    const float pdf = emitter.map->pdf(to_light);
    return {to_light, V3f(0.0f), true, pdf, pdf > 0.0f ? 1.0f : 0.0f};
}

float pdf_of(const PointEmitter&, const MetEmitter&) noexcept { return 0.0f; }
float pdf_of(const SpotEmitter&, const MetEmitter&) noexcept { return 0.0f; }
float pdf_of(const DistantEmitter&, const MetEmitter&) noexcept { return 0.0f; }
float pdf_of(const InfiniteEmitter&, const MetEmitter&) noexcept { return kInfiniteEmitterPdf; }
float pdf_of(const ImageEmitter& emitter, const MetEmitter& met) noexcept { return emitter.map->pdf(met.direction); }

}  // namespace

EmitterSample sample(const EmitterGeometry& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    return std::visit([&](const auto& e) { return sample_one(e, from, u); }, emitter);
}

float direction_pdf(const EmitterGeometry& emitter, const V3f& from, const V3f& direction, const V3f& point,
                    const V3f& normal) noexcept {
    return std::visit([met = MetEmitter{from, direction, point, normal}](const auto& e) { return pdf_of(e, met); },
                      emitter);
}

EmitterPicker::EmitterPicker(const std::vector<double>& weights) : cells_(weights.size()) {
    // Each cell is filled up to the mean: one emitter that needs less, topped up by one that needs more.
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
    std::vector<double> left(weights);
    std::vector<std::uint32_t> small, large;
    for (std::uint32_t i = 0; i < left.size(); ++i) (left[i] < mean ? small : large).push_back(i);
    while (!small.empty() && !large.empty()) {
        const std::uint32_t needy = small.back(), rich = large.back();
        small.pop_back();
        cells_[needy] = {left[needy] / mean, rich};
        left[rich] -= mean - left[needy];
        if (left[rich] < mean) {
            large.pop_back();
            small.push_back(rich);
        }
    }
    for (const std::uint32_t i : small) cells_[i] = {1.0, i};
    for (const std::uint32_t i : large) cells_[i] = {1.0, i};
}

}  // namespace emulsion
