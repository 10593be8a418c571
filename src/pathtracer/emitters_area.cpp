#include "pathtracer/emitters_area.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "pathtracer/bilinear.h"
#include "pathtracer/spherical_triangle.h"

namespace emulsion {

namespace {

using Imath::V2d;
using Imath::V3d;
using Imath::V3f;

constexpr double kPi = std::numbers::pi;

/// From density per area to density per steradian.
float solid_angle_pdf(double area_pdf, float distance2, float cosine) noexcept {
    return static_cast<float>(area_pdf * static_cast<double>(distance2 / std::abs(cosine)));
}
float solid_angle_pdf(double area_pdf, const MetEmitter& met) noexcept {
    return solid_angle_pdf(area_pdf, (met.point - met.from).length2(), met.direction.dot(met.normal));
}

/// From a point of a surface, drawn with `area_pdf` per unit of its area, to a sample of directions.
EmitterSample from_area(const SurfacePoint& light, double area_pdf, bool two_sided, const V3f& from) noexcept {
    const V3f to = light.position - from;
    const float distance2 = to.dot(to);
    EmitterSample sample;
    if (!(distance2 > 0.0f)) return sample;
    sample.to_light = to * (1.0f / std::sqrt(distance2));
    const float cosine = -sample.to_light.dot(light.geometric_normal);
    if (two_sided ? cosine == 0.0f : cosine <= 0.0f) return sample;
    sample.target = light.origin_towards(-sample.to_light);
    sample.pdf = solid_angle_pdf(area_pdf, distance2, cosine);
    sample.scale = 1.0f;
    return sample;
}

// --- Flat faces

/// Triangles and flat patches that are seen under less than this, in steradians, are sampled by area: see
/// docs/geometry.md for the measured errors of both, and what they cost.
constexpr double kLeastSolidAngle = 0.1;
constexpr double kTanHalfLeast = 0.05004172928;  // tan(0.05)

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

/// The triangle as it is seen from a point, if that is under kLeastSolidAngle at least. Most are not, and this is found
/// out without the solid angle itself.
std::optional<SphericalTriangle> seen_large(const TriangleEmitter& emitter, const V3f& from) noexcept {
    if ((emitter.centre - from).length2() > emitter.large_within2) return std::nullopt;
    const TriangleEdges edges(*emitter.mesh, emitter.triangle);
    const V3d p0 = edges.p0 - V3d(from), p1 = p0 + edges.edge1, p2 = p0 + edges.edge2;
    if (!is_seen_above(kTanHalfLeast, p0, p1, p2)) return std::nullopt;
    return SphericalTriangle(p0, p1, p2);
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

TriangleEmitter emitter_of(const TriangleMesh& mesh, std::uint32_t triangle) noexcept {
    const TriangleEdges edges(mesh, triangle);
    const TriangleFace face(mesh, edges);
    const V3d centre = (edges.edge1 + edges.edge2) * (1.0 / 3.0);
    // No point of the triangle is further from its centre than a corner. A little more, for rounding.
    const double reach2 =
        std::max({centre.length2(), (centre - edges.edge1).length2(), (centre - edges.edge2).length2()});
    const double large_within = 1.001 * (std::sqrt(reach2) + std::sqrt(face.area / kLeastSolidAngle));
    return {.mesh = &mesh,
            .triangle = triangle,
            .large_within2 = static_cast<float>(large_within * large_within),
            .centre = V3f(edges.p0 + centre),
            .face = face};
}

EmitterSample sample_one(const TriangleEmitter& emitter, const V3f& from, std::array<float, 2> u) noexcept {
    const TriangleEdges edges(*emitter.mesh, emitter.triangle);
    Hit hit{.primitive = emitter.triangle};
    if (const auto seen = seen_large(emitter, from)) {
        const V3d direction = sample(*seen, {static_cast<double>(u[0]), static_cast<double>(u[1])});
        std::tie(hit.u, hit.v) = where_met(edges.p0 - V3d(from), edges.edge1, edges.edge2, direction);
        const SurfacePoint light = surface_point(*emitter.mesh, edges, emitter.face, hit);
        return towards(light, direction, seen->solid_angle, emitter.two_sided);
    }
    // Uniform over the area. Source: Heitz, "A Low-Distortion Map Between Triangle and Square", 2019.
    const bool lower = u[0] > u[1];
    hit.u = lower ? u[0] - 0.5f * u[1] : 0.5f * u[0];
    hit.v = lower ? 0.5f * u[1] : u[1] - 0.5f * u[0];
    const SurfacePoint light = surface_point(*emitter.mesh, edges, emitter.face, hit);
    return from_area(light, 1.0 / emitter.face.area, emitter.two_sided, from);
}

float pdf_of(const TriangleEmitter& emitter, const MetEmitter& met) noexcept {
    const auto seen = seen_large(emitter, met.from);
    if (seen) return static_cast<float>(1.0 / seen->solid_angle);
    return solid_angle_pdf(1.0 / emitter.face.area, met);
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
    return solid_angle_pdf(patch_area_pdf(patch, met_uv(*emitter.mesh, patch, met)), met);
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
            return solid_angle_pdf(1.0 / (quadric.object_area * stretch), met);
        },
        *emitter.quadric);
}

}  // namespace emulsion
