#include "pathtracer/scene_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "pathtracer/bilinear.h"
#include "pathtracer/quadrics.h"
#include "pathtracer/scene_mesh.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

/// \throws SceneError if the box of half-width `across` in x and y, and from z_min to z_max, is not within reach.
void check_reach(const ParameterList& list, const Imath::M44d& m, double across, double z_min, double z_max) {
    const double up = std::max(std::abs(z_min), std::abs(z_max));
    for (int axis = 0; axis < 3; ++axis) {
        const double reach =
            std::hypot(m[0][axis], m[1][axis]) * across + std::abs(m[2][axis]) * up + std::abs(m[3][axis]);
        if (reach <= kReach) continue;
        throw SceneError(list.place, fmt::format("a {} that reaches to {:g}", list.owner, reach),
                         std::string(kWithinReach));
    }
    if (!inverse_of(m)) {
        throw SceneError(list.place, fmt::format("a {} under a transformation without inverse", list.owner),
                         "another one");
    }
}

double phi_max_of(const ParameterList& list) noexcept {
    return std::clamp(real_or(list, "phimax", 360.0), 0.0, 360.0) * (std::numbers::pi / 180.0);
}

bool flips_normal(const ShapeFrame& frame) noexcept {
    return (frame.orientation == Orientation::reversed) != swaps_handedness(frame.world_from_object);
}

/// The shape, or none and a warning.
template <class Quadric>
std::vector<Geometry> unless_empty(const Quadric& quadric, bool has_area, const ParameterList& list,
                                   ShapeReading& reading) {
    if (has_area) return {quadric};
    reading.warnings.add(list.place, fmt::format("a {} without area, left out", list.owner));
    return {};
}

std::vector<Geometry> read_sphere(const ParameterList& list, const ShapeFrame& frame, ShapeReading& reading) {
    Sphere sphere{frame.world_from_object, real_or(list, "radius", 1.0), flips_normal(frame)};
    const auto [low, high] = std::minmax({real_or(list, "zmin", -sphere.radius), real_or(list, "zmax", sphere.radius)});
    if (low > -sphere.radius) sphere.z_min = low;
    if (high < sphere.radius) sphere.z_max = high;
    sphere.phi_max = phi_max_of(list);
    check_reach(list, frame.world_from_object, sphere.radius, sphere.radius, sphere.radius);
    const bool has_area = low < high && low < sphere.radius && high > -sphere.radius && sphere.phi_max > 0.0;
    return unless_empty(sphere, has_area, list, reading);
}

std::vector<Geometry> read_disk(const ParameterList& list, const ShapeFrame& frame, ShapeReading& reading) {
    Disk disk{.world_from_object = frame.world_from_object,
              .height = real_or(list, "height", 0.0),
              .radius = real_or(list, "radius", 1.0),
              .inner_radius = real_or(list, "innerradius", 0.0),
              .phi_max = phi_max_of(list),
              .flip_normal = flips_normal(frame)};
    check_reach(list, frame.world_from_object, disk.radius, disk.height, disk.height);
    return unless_empty(disk, disk.inner_radius < disk.radius && disk.phi_max > 0.0, list, reading);
}

std::vector<Geometry> read_cylinder(const ParameterList& list, const ShapeFrame& frame, ShapeReading& reading) {
    const auto [low, high] = std::minmax({real_or(list, "zmin", -1.0), real_or(list, "zmax", 1.0)});
    Cylinder cylinder{.world_from_object = frame.world_from_object,
                      .radius = real_or(list, "radius", 1.0),
                      .z_min = low,
                      .z_max = high,
                      .phi_max = phi_max_of(list),
                      .flip_normal = flips_normal(frame)};
    check_reach(list, frame.world_from_object, cylinder.radius, low, high);
    return unless_empty(cylinder, low < high && cylinder.phi_max > 0.0, list, reading);
}

struct ShapeReader {
    std::string_view name;
    std::vector<Geometry> (*read)(const ParameterList&, const ShapeFrame&, ShapeReading&);
};
constexpr auto kReaders = std::to_array<ShapeReader>({{"trianglemesh", read_triangle_mesh},
                                                      {"bilinearmesh", read_bilinear_mesh},
                                                      {"plymesh", read_ply_mesh},
                                                      {"sphere", read_sphere},
                                                      {"disk", read_disk},
                                                      {"cylinder", read_cylinder}});

std::vector<double> areas_of(const TriangleMesh& mesh) {
    std::vector<double> areas;
    areas.reserve(mesh.triangle.size());
    for (const auto& corner : mesh.triangle) {
        const Imath::V3d p0(mesh.position[corner[0]]);
        const Imath::V3d edge1 = Imath::V3d(mesh.position[corner[1]]) - p0;
        areas.push_back(0.5 * edge1.cross(Imath::V3d(mesh.position[corner[2]]) - p0).length());
    }
    return areas;
}
std::vector<double> areas_of(const BilinearMesh& mesh) {
    std::vector<double> areas;
    areas.reserve(mesh.patch.size());
    for (std::uint32_t i = 0; i < mesh.patch.size(); ++i) areas.push_back(area_of(BilinearPatch(mesh, i)));
    return areas;
}
template <class Quadric>
std::vector<double> areas_of(const Quadric& quadric) {
    return {std::visit([](const auto& q) { return q.object_area; }, prepared(quadric))};
}

}  // namespace

std::vector<Geometry> read_shape(const ParameterList& list, const ShapeFrame& frame, ShapeReading reading) {
    check_parameters(shape_table(), list);
    return supported_row<ShapeReader>(list.place, {"shape"}, list.owner, kReaders).read(list, frame, reading);
}

std::vector<double> light_areas(const Geometry& geometry) {
    return std::visit([](const auto& shape) { return areas_of(shape); }, geometry);
}

}  // namespace emulsion
