#include "pathtracer/emitters_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "pathtracer/bilinear.h"
#include "pathtracer/spherical_triangle.h"
#include "pathtracer/surface.h"

namespace emulsion {

namespace {

using Imath::V2d;
using Imath::V3d;
using Imath::V3f;

constexpr double kPi = std::numbers::pi;

/// From a point of a surface, drawn with `area_pdf` per unit of its area, to a sample of directions.
EmitterSample from_area(const SurfacePoint& light, double area_pdf, bool two_sided, const V3f& from) noexcept {
    const V3d to = V3d(light.position) - V3d(from);
    const double distance2 = to.length2();
    EmitterSample sample;
    if (!(distance2 > 0.0)) return sample;
    sample.to_light = V3f(to * (1.0 / std::sqrt(distance2)));
    const float cosine = -sample.to_light.dot(light.geometric_normal);
    if (two_sided ? cosine == 0.0f : cosine <= 0.0f) return sample;
    sample.target = light.origin_towards(-sample.to_light);
    sample.pdf = static_cast<float>(area_pdf * distance2 / static_cast<double>(std::abs(cosine)));
    sample.scale = 1.0f;
    return sample;
}

float solid_angle_pdf(const MetEmitter& met, double area_pdf) noexcept {
    const double distance2 = (V3d(met.point) - V3d(met.from)).length2();
    return static_cast<float>(area_pdf * distance2 / static_cast<double>(std::abs(met.direction.dot(met.normal))));
}

// --- Flat faces

/// Triangles and flat patches that are seen under less than this, in steradians, are sampled by area: see
/// docs/geometry.md for the measured errors of both, and what they cost.
constexpr double kLeastSolidAngle = 0.1;

/// A sample in a direction drawn uniformly from a solid angle.
EmitterSample towards(const SurfacePoint& light, const V3d& direction, double solid_angle, bool two_sided) noexcept {
    EmitterSample sample;
    sample.to_light = unit(V3f(direction));
    if (!two_sided && sample.to_light.dot(light.geometric_normal) >= 0.0f) return sample;
    sample.target = light.origin_towards(-sample.to_light);
    sample.pdf = static_cast<float>(1.0 / solid_angle);
    sample.scale = 1.0f;
    return sample;
}

/// Whether a triangle with its first corner at p0 from the receiver may be seen under kLeastSolidAngle: no point of it
/// is further from the first corner than the longer of the two edges that start there.
bool may_be_large(const V3d& p0, const TriangleGeometry& triangle) noexcept {
    const double reach = std::sqrt(std::max(triangle.edge1.length2(), triangle.edge2.length2()));
    const double closest = std::max(0.0, p0.length() - reach);
    return triangle.area >= kLeastSolidAngle * closest * closest;
}

/// Where on the triangle a ray from the origin goes, kept within: p0 + u edge1 + v edge2.
std::pair<float, float> where_met(const V3d& p0, const V3d& edge1, const V3d& edge2, const V3d& direction) noexcept {
    const V3d across = direction.cross(edge2);
    const double determinant = across.dot(edge1);
    const double u = std::clamp(-across.dot(p0) / determinant, 0.0, 1.0);
    const double v = std::clamp(-direction.dot(p0.cross(edge1)) / determinant, 0.0, 1.0 - u);
    return {static_cast<float>(u), static_cast<float>(v)};
}

/// The two triangles of a flat patch.
struct SeenPatch {
    SphericalTriangle lower, upper;

    SeenPatch(const BilinearPatch& patch, const V3d& from) noexcept
        : lower(patch.p00 - from, patch.p10 - from, patch.p01 - from),
          upper(patch.p11 - from, patch.p01 - from, patch.p10 - from) {}
};

// --- Spheres

/// 1 - cos of the half-angle under which the sphere is seen, if it keeps its shape and is surely seen from outside: a
/// point of its own surface may lie outside by rounding, and see the side that is meant for it all the same.
std::optional<double> cone_height(const PreparedSphere& sphere, const V3d& from) noexcept {
    if (!sphere.world_centre) return std::nullopt;
    const double sin2 = sphere.world_radius * sphere.world_radius / (*sphere.world_centre - from).length2();
    const double coordinate = std::max({std::abs(from.x), std::abs(from.y), std::abs(from.z)});
    const double rounding = 4.0 * static_cast<double>(kPositionOffset) * coordinate / sphere.world_radius;
    if (!(sin2 < 1.0 - std::max(1e-6, rounding))) return std::nullopt;
    return sin2 / (1.0 + std::sqrt(1.0 - sin2));
}

/// Uniform over the cone of directions that meet the sphere; then the near one of the two points on the line.
EmitterSample sample_cone(const PreparedSphere& sphere, double height, bool two_sided, const V3f& from,
                          std::array<float, 2> u) noexcept {
    const V3d axis = *sphere.world_centre - V3d(from);
    const double distance = axis.length();
    const Frame frame{V3f(axis / distance)};
    const double lowered = static_cast<double>(u[0]) * height;  // 1 - cos
    const double sine = std::sqrt(std::max(0.0, lowered * (2.0 - lowered)));
    const double angle = 2.0 * kPi * static_cast<double>(u[1]);
    const V3d direction = V3d(frame.tangent) * (sine * std::cos(angle)) +
                          V3d(frame.bitangent) * (sine * std::sin(angle)) + (axis / distance) * (1.0 - lowered);
    const double past = distance * sine;
    const double t =
        distance * (1.0 - lowered) - std::sqrt(std::max(0.0, sphere.world_radius * sphere.world_radius - past * past));
    const SurfacePoint light = surface_point(point_at(sphere, V3d(from) + t * direction));
    EmitterSample sample;
    sample.to_light = unit(V3f(direction));
    if (!two_sided && sample.to_light.dot(light.geometric_normal) >= 0.0f) return sample;
    sample.target = light.origin_towards(-sample.to_light);
    sample.pdf = static_cast<float>(1.0 / (2.0 * kPi * height));
    sample.scale = 1.0f;
    return sample;
}

// --- Patches

double patch_area_pdf(const BilinearPatch& patch, const V2d& uv) noexcept {
    const double area = patch.cross(uv.x, uv.y).length();
    return area > 0.0 ? 1.0 / area : 0.0;
}

/// The (u, v) of what a ray has met: of a patch that is not flat a ray may meet two points, and Newton's method either.
V2d met_uv(const BilinearMesh& mesh, const BilinearPatch& patch, const MetEmitter& met) noexcept {
    if (!mesh.flat) {
        const double distance = (V3d(met.point) - V3d(met.from)).length();
        const auto hit = first_hit(patch, V3d(met.from), V3d(met.direction), 0.999 * distance, 1.001 * distance);
        if (hit) return {hit->u, hit->v};
    }
    return patch_uv(patch, V3d(met.point));
}

}  // namespace

EmitterSample sample_one(const TriangleEmitter& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    const TriangleGeometry triangle(*emitter.mesh, emitter.triangle);
    const V3d p0 = triangle.p0 - V3d(from);
    Hit hit{.primitive = emitter.triangle};
    if (may_be_large(p0, triangle)) {
        const SphericalTriangle seen(p0, p0 + triangle.edge1, p0 + triangle.edge2);
        if (seen.solid_angle >= kLeastSolidAngle) {
            const V3d direction = sample(seen, {static_cast<double>(u[0]), static_cast<double>(u[1])});
            std::tie(hit.u, hit.v) = where_met(p0, triangle.edge1, triangle.edge2, direction);
            return towards(surface_point(*emitter.mesh, triangle, hit), direction, seen.solid_angle, emitter.two_sided);
        }
    }
    // Uniform over the area. Source: Heitz, "A Low-Distortion Map Between Triangle and Square", 2019.
    const bool lower = u[0] > u[1];
    hit.u = lower ? u[0] - 0.5f * u[1] : 0.5f * u[0];
    hit.v = lower ? 0.5f * u[1] : u[1] - 0.5f * u[0];
    return from_area(surface_point(*emitter.mesh, triangle, hit), 1.0 / triangle.area, emitter.two_sided, from);
}

float pdf_of(const TriangleEmitter& emitter, const MetEmitter& met) noexcept {
    const TriangleGeometry triangle(*emitter.mesh, emitter.triangle);
    const V3d p0 = triangle.p0 - V3d(met.from);
    if (may_be_large(p0, triangle)) {
        const double solid_angle = SphericalTriangle(p0, p0 + triangle.edge1, p0 + triangle.edge2).solid_angle;
        if (solid_angle >= kLeastSolidAngle) return static_cast<float>(1.0 / solid_angle);
    }
    return solid_angle_pdf(met, 1.0 / triangle.area);
}

EmitterSample sample_one(const PatchEmitter& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    const BilinearPatch patch(*emitter.mesh, emitter.patch);
    V2d uv(static_cast<double>(u[0]), static_cast<double>(u[1]));
    if (emitter.mesh->flat) {
        // Two triangles are one where they are seen: each is drawn by its share of the solid angle.
        const SeenPatch seen(patch, V3d(from));
        const double total = seen.lower.solid_angle + seen.upper.solid_angle;
        if (total >= kLeastSolidAngle) {
            const double drawn = uv.x * total;
            const bool is_lower = drawn < seen.lower.solid_angle;
            const SphericalTriangle& part = is_lower ? seen.lower : seen.upper;
            const double within = (is_lower ? drawn : drawn - seen.lower.solid_angle) / part.solid_angle;
            const V3d direction = sample(part, {std::min(within, 1.0), uv.y});
            const V3d normal = (patch.p11 - patch.p00).cross(patch.p01 - patch.p10);
            const double t = normal.dot(patch.p00 - V3d(from)) / normal.dot(direction);
            uv = patch_uv(patch, V3d(from) + direction * t);
            return towards(surface_point(*emitter.mesh, emitter.patch, uv), direction, total, emitter.two_sided);
        }
    }
    const double area_pdf = patch_area_pdf(patch, uv);
    if (area_pdf == 0.0) return {};
    return from_area(surface_point(*emitter.mesh, emitter.patch, uv), area_pdf, emitter.two_sided, from);
}

float pdf_of(const PatchEmitter& emitter, const MetEmitter& met) noexcept {
    const BilinearPatch patch(*emitter.mesh, emitter.patch);
    if (emitter.mesh->flat) {
        const SeenPatch seen(patch, V3d(met.from));
        const double total = seen.lower.solid_angle + seen.upper.solid_angle;
        if (total >= kLeastSolidAngle) return static_cast<float>(1.0 / total);
    }
    return solid_angle_pdf(met, patch_area_pdf(patch, met_uv(*emitter.mesh, patch, met)));
}

EmitterSample sample_one(const QuadricEmitter& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    if (const auto* const sphere = std::get_if<PreparedSphere>(emitter.quadric)) {
        if (const auto height = cone_height(*sphere, V3d(from))) {
            return sample_cone(*sphere, *height, emitter.two_sided, from, u);
        }
    }
    return std::visit(
        [&](const auto& quadric) {
            const QuadricPoint point = sample_area(quadric, u);
            const double area_pdf = 1.0 / (quadric.object_area * point.area_stretch);
            return from_area(surface_point(point), area_pdf, emitter.two_sided, from);
        },
        *emitter.quadric);
}

float pdf_of(const QuadricEmitter& emitter, const MetEmitter& met) noexcept {
    if (const auto* const sphere = std::get_if<PreparedSphere>(emitter.quadric)) {
        if (const auto height = cone_height(*sphere, V3d(met.from))) {
            return static_cast<float>(1.0 / (2.0 * kPi * *height));
        }
    }
    return std::visit(
        [&](const auto& quadric) {
            const double stretch = point_at(quadric, V3d(met.point)).area_stretch;
            return solid_angle_pdf(met, 1.0 / (quadric.object_area * stretch));
        },
        *emitter.quadric);
}

}  // namespace emulsion
