#include "pathtracer/emitters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace emulsion {

namespace {

using Imath::V3d;
using Imath::V3f;

constexpr double kPi = std::numbers::pi;

/// From a point of a surface, drawn with `area_pdf` per unit of its area, to a sample of directions.
EmitterSample from_area(const SurfacePoint& light, float area_pdf, bool two_sided, const V3f& from) noexcept {
    const V3f to = light.position - from;
    const float distance2 = to.dot(to);
    EmitterSample sample;
    if (!(distance2 > 0.0f)) return sample;
    sample.to_light = to * (1.0f / std::sqrt(distance2));
    const float cosine = -sample.to_light.dot(light.geometric_normal);
    if (two_sided ? cosine == 0.0f : cosine <= 0.0f) return sample;
    sample.target = light.origin_towards(-sample.to_light);
    sample.pdf = area_pdf * distance2 / std::abs(cosine);
    sample.scale = 1.0f;
    return sample;
}

EmitterSample sample_one(const TriangleEmitter& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    // Uniform over the area. Source: Heitz, "A Low-Distortion Map Between Triangle and Square", 2019.
    const bool lower = u[0] > u[1];
    const float b1 = lower ? u[0] - 0.5f * u[1] : 0.5f * u[0], b2 = lower ? 0.5f * u[1] : u[1] - 0.5f * u[0];
    const TriangleGeometry& t = emitter.triangle;
    return from_area({t.at(b1, b2), t.normal, t.normal, t.offset}, 1.0f / t.area, emitter.two_sided, from);
}

/// 1 - cos of the half-angle under which the sphere is seen, if it keeps its shape and is surely seen from outside: a
/// point of its own surface may lie outside by rounding, and see the side that is meant for it all the same.
std::optional<double> cone_height(const PreparedSphere& sphere, const V3d& from) noexcept {
    if (!sphere.world_centre) return std::nullopt;
    const double sin2 = sphere.world_radius * sphere.world_radius / (*sphere.world_centre - from).length2();
    const double rounding = 4.0 * static_cast<double>(kRelativeOffset * sphere.extent) / sphere.world_radius;
    if (!(sin2 < 1.0 - std::max(1e-6, rounding))) return std::nullopt;
    return sin2 / (1.0 + std::sqrt(1.0 - sin2));
}

float sphere_area_pdf(const PreparedSphere& sphere, const SpherePoint& point) noexcept {
    return static_cast<float>(1.0 / (4.0 * kPi * sphere.radius * sphere.radius * point.area_stretch));
}

EmitterSample sample_one(const SphereEmitter& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    const PreparedSphere& sphere = emitter.sphere;
    const auto height = cone_height(sphere, V3d(from));
    if (!height) {
        const SpherePoint point = point_towards(sphere, V3d(uniform_sphere(u)));
        return from_area(surface_point(sphere, point), sphere_area_pdf(sphere, point), emitter.two_sided, from);
    }
    // Uniform over the cone of directions that meet the sphere; then the near one of the two points on the line.
    const V3d axis = (*sphere.world_centre - V3d(from));
    const double distance = axis.length();
    const Frame frame{V3f(axis / distance)};
    const double lowered = static_cast<double>(u[0]) * *height;  // 1 - cos
    const double sine = std::sqrt(std::max(0.0, lowered * (2.0 - lowered)));
    const double angle = 2.0 * kPi * static_cast<double>(u[1]);
    const V3d direction = V3d(frame.tangent) * (sine * std::cos(angle)) +
                          V3d(frame.bitangent) * (sine * std::sin(angle)) + (axis / distance) * (1.0 - lowered);
    const double past = distance * sine;
    const double t =
        distance * (1.0 - lowered) - std::sqrt(std::max(0.0, sphere.world_radius * sphere.world_radius - past * past));
    const SurfacePoint light = surface_point(sphere, point_at(sphere, V3d(from) + t * direction));
    EmitterSample sample;
    sample.to_light = unit(V3f(direction));
    if (!emitter.two_sided && sample.to_light.dot(light.geometric_normal) >= 0.0f) return sample;
    sample.target = light.origin_towards(-sample.to_light);
    sample.pdf = static_cast<float>(1.0 / (2.0 * kPi * *height));
    sample.scale = 1.0f;
    return sample;
}

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

EmitterSample sample_one(const DistantEmitter& emitter, const V3f&, std::array<float, 2>) noexcept {
    return {emitter.to_light, V3f(0.0f), true, 0.0f, 1.0f};
}

EmitterSample sample_one(const InfiniteEmitter&, const V3f&, std::array<float, 2> u) noexcept {
    return {uniform_sphere(u), V3f(0.0f), true, kInfiniteEmitterPdf, 1.0f};
}

/// What a ray has met.
struct Met {
    V3f from, direction, point, normal;

    [[nodiscard]] float solid_angle_pdf(float area_pdf) const noexcept {
        const V3f to = point - from;
        return area_pdf * to.dot(to) / std::abs(direction.dot(normal));
    }
};

float pdf_of(const TriangleEmitter& emitter, const Met& met) noexcept {
    return met.solid_angle_pdf(1.0f / emitter.triangle.area);
}
float pdf_of(const SphereEmitter& emitter, const Met& met) noexcept {
    if (const auto height = cone_height(emitter.sphere, V3d(met.from))) {
        return static_cast<float>(1.0 / (2.0 * kPi * *height));
    }
    return met.solid_angle_pdf(sphere_area_pdf(emitter.sphere, point_at(emitter.sphere, V3d(met.point))));
}
float pdf_of(const PointEmitter&, const Met&) noexcept { return 0.0f; }
float pdf_of(const DistantEmitter&, const Met&) noexcept { return 0.0f; }
float pdf_of(const InfiniteEmitter&, const Met&) noexcept { return kInfiniteEmitterPdf; }

}  // namespace

EmitterSample sample(const EmitterGeometry& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    return std::visit([&](const auto& e) { return sample_one(e, from, u); }, emitter);
}

float direction_pdf(const EmitterGeometry& emitter, const V3f& from, const V3f& direction, const V3f& point,
                    const V3f& normal) noexcept {
    return std::visit([met = Met{from, direction, point, normal}](const auto& e) { return pdf_of(e, met); }, emitter);
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
