#include "pathtracer/scene_shapes.h"

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pathtracer/scene_mesh.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

std::optional<ReadShape> read_sphere(const ParameterList& list, const ShapeFrame& frame, std::vector<std::string>&) {
    const double radius = real_or(list, "radius", 1.0);
    for (const std::string_view end : {"zmin", "zmax"}) {
        const bool low = end == "zmin";
        const SceneParameter* const parameter = find_parameter(list, end);
        const double z = real_or(list, end, low ? -radius : radius);
        if (low ? z <= -radius : z >= radius) continue;
        throw SceneError(parameter->first_value, fmt::format(R"({} for parameter "{}" of shape "sphere")", z, end),
                         fmt::format("{} or {} (others are known to pbrt-v4 and not yet supported here)",
                                     low ? -radius : radius, low ? "below" : "above"));
    }
    const Imath::M44d& m = frame.world_from_object;
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = Imath::V3d(m[0][axis], m[1][axis], m[2][axis]).length() * radius + std::abs(m[3][axis]);
        if (reach <= kReach) continue;
        throw SceneError(list.place, fmt::format("a sphere that reaches to {:g}", reach), std::string(kWithinReach));
    }
    if (!inverse_of(m)) throw SceneError(list.place, "a sphere under a transformation without inverse", "another one");
    return ReadShape{Sphere{frame.world_from_object, radius, frame.orientation == Orientation::reversed},
                     {4.0 * std::numbers::pi * radius * radius}};
}

struct ShapeReader {
    std::string_view name;
    std::optional<ReadShape> (*read)(const ParameterList&, const ShapeFrame&, std::vector<std::string>&);
};
constexpr auto kReaders = std::to_array<ShapeReader>(
    {{"trianglemesh", read_triangle_mesh}, {"bilinearmesh", read_bilinear_mesh}, {"sphere", read_sphere}});

}  // namespace

std::optional<ReadShape> read_shape(const ParameterList& list, const ShapeFrame& frame,
                                    std::vector<std::string>& warnings) {
    check_parameters(shape_table(), list);
    return supported_row<ShapeReader>(list.place, {"shape"}, list.owner, kReaders).read(list, frame, warnings);
}

}  // namespace emulsion
