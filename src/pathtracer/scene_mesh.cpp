#include "pathtracer/scene_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Patch = std::array<std::uint32_t, 4>;  // p00 p10 p01 p11

Imath::V3d point_of(const std::vector<double>& numbers, std::size_t index) noexcept {
    return {numbers[3 * index], numbers[3 * index + 1], numbers[3 * index + 2]};
}

/// \throws SceneError naming a triple of coordinates that is too large for `most`.
Imath::V3f single_precision(const Imath::V3d& v, double most, std::string_view expected,
                            const SceneParameter& parameter, std::size_t index) {
    const bool fits = std::abs(v.x) <= most && std::abs(v.y) <= most && std::abs(v.z) <= most;
    if (fits) return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    throw SceneError(
        place_of_value(parameter, 3 * index),
        fmt::format("({:g}, {:g}, {:g}) in world space for parameter \"{}\"", v.x, v.y, v.z, parameter.name),
        std::string(expected));
}

/// One value per vertex, or none at all.
const SceneParameter* per_vertex(const ParameterList& list, std::string_view name, std::size_t components,
                                 std::size_t vertices) {
    const SceneParameter* const parameter = find_parameter(list, name);
    if (parameter == nullptr || parameter->numbers.size() == components * vertices) return parameter;
    throw SceneError(parameter->place,
                     fmt::format(R"(parameter "{}" of length {})", name, parameter->numbers.size() / components),
                     fmt::format(R"(length {}, that of "P")", vertices));
}

/// Texture coordinates, and tangents in world space.
void read_coordinates(const ParameterList& list, const ShapeFrame& frame, TriangleMesh& mesh) {
    const std::size_t vertices = mesh.position.size();
    constexpr double kMost = std::numeric_limits<float>::max();
    constexpr std::string_view kHeld = "coordinates that single precision holds";
    if (const SceneParameter* const uv = per_vertex(list, "uv", 2, vertices)) {
        mesh.uv.reserve(vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            const double u = uv->numbers[2 * i], v = uv->numbers[2 * i + 1];
            if (!(std::abs(u) <= kMost && std::abs(v) <= kMost)) {
                throw SceneError(place_of_value(*uv, 2 * i), fmt::format(R"(({:g}, {:g}) for parameter "uv")", u, v),
                                 std::string(kHeld));
            }
            mesh.uv.emplace_back(static_cast<float>(u), static_cast<float>(v));
        }
    }
    if (const SceneParameter* const tangents = per_vertex(list, "S", 3, vertices)) {
        mesh.tangent.reserve(vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            const Imath::V3d world = transform_vector(frame.world_from_object, point_of(tangents->numbers, i));
            mesh.tangent.push_back(single_precision(world, kMost, kHeld, *tangents, i));
        }
    }
}

/// Positions, normals and coordinates in world space; no triangles yet.
TriangleMesh read_vertices(const ParameterList& list, const ShapeFrame& frame) {
    const SceneParameter* const positions = find_parameter(list, "P");
    if (positions == nullptr) {
        throw SceneError(list.place, fmt::format("shape \"{}\" without positions", list.owner), "a parameter \"P\"");
    }
    const std::size_t vertices = positions->numbers.size() / 3;
    TriangleMesh mesh;
    mesh.position.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        const Imath::V3d world = transform_point(frame.world_from_object, point_of(positions->numbers, i));
        mesh.position.push_back(single_precision(world, kReach, kWithinReach, *positions, i));
    }
    read_coordinates(list, frame, mesh);

    const bool reversed = frame.orientation == Orientation::reversed;
    if (const SceneParameter* const normals = per_vertex(list, "N", 3, vertices)) {
        const std::optional<Imath::M44d> matrix = normal_matrix(frame.world_from_object);
        if (!matrix) throw SceneError(normals->place, "normals under a transformation without inverse", "another one");
        mesh.normal.reserve(vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            const Imath::V3d world = transform_vector(*matrix, point_of(normals->numbers, i)) * (reversed ? -1.0 : 1.0);
            mesh.normal.push_back(single_precision(world, std::numeric_limits<float>::max(),
                                                   "coordinates that single precision holds", *normals, i));
        }
    } else {
        mesh.flip_normal = reversed != swaps_handedness(frame.world_from_object);
    }
    return mesh;
}

/// Reads "indices", Corners of them a face.
template <std::size_t Corners>
std::vector<std::array<std::uint32_t, Corners>> read_faces(const ParameterList& list, std::size_t vertices) {
    const SceneParameter* const indices = find_parameter(list, "indices");
    if (indices == nullptr) {
        std::array<std::uint32_t, Corners> only{};
        for (std::uint32_t i = 0; i < Corners; ++i) only[i] = i;
        if (vertices == Corners) return {only};
        throw SceneError(list.place, fmt::format("{} positions and no parameter \"indices\"", vertices),
                         fmt::format("\"indices\", or exactly {} positions", Corners));
    }
    const std::vector<double>& numbers = indices->numbers;
    if (numbers.size() % Corners != 0) {
        throw SceneError(indices->place, fmt::format("{} values for parameter \"indices\"", numbers.size()),
                         fmt::format("a multiple of {}", Corners));
    }
    std::vector<std::array<std::uint32_t, Corners>> faces(numbers.size() / Corners);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (!(numbers[i] >= 0.0 && numbers[i] < static_cast<double>(vertices))) {
            throw SceneError(place_of_value(*indices, i), fmt::format("the index {}", numbers[i]),
                             fmt::format("one from 0 to {}, as \"P\" has {} positions", vertices - 1, vertices));
        }
        faces[i / Corners][i % Corners] = static_cast<std::uint32_t>(numbers[i]);
    }
    return faces;
}

/// The cross product of two edges, (p1 - p0) x (p2 - p0): twice the area long.
Imath::V3d edge_cross(const TriangleMesh& mesh, const Triangle& triangle) noexcept {
    const Imath::V3d p0(mesh.position[triangle[0]]);
    return (Imath::V3d(mesh.position[triangle[1]]) - p0).cross(Imath::V3d(mesh.position[triangle[2]]) - p0);
}

/// Leaves out triangles without area. `face_size` triangles in a row are one face of the file.
std::optional<ReadShape> finish_mesh(TriangleMesh mesh, const std::vector<Triangle>& triangles, std::size_t face_size,
                                     const ParameterList& list, std::vector<std::string>& warnings) {
    std::vector<double> light_areas;
    mesh.triangle.reserve(triangles.size());
    light_areas.reserve(triangles.size());
    for (std::size_t face = 0; face < triangles.size(); face += face_size) {
        double face_area = 0.0;
        for (std::size_t i = face; i < face + face_size; ++i) {
            const double area = 0.5 * edge_cross(mesh, triangles[i]).length();
            face_area += area;
            if (area > 0.0) mesh.triangle.push_back(triangles[i]);
        }
        light_areas.resize(mesh.triangle.size(), face_area);
    }
    const std::size_t dropped = triangles.size() - mesh.triangle.size();
    if (dropped > 0) {
        warnings.push_back(fmt::format("{}: triangles without area, left out: {} of {}", to_text(list.place), dropped,
                                       triangles.size()));
    }
    if (mesh.triangle.empty()) return std::nullopt;
    return ReadShape{std::move(mesh), std::move(light_areas)};
}

/// Whether the four corners lie in one plane, to 1e-5 of the longer diagonal.
bool is_flat(const std::array<Imath::V3d, 4>& corner) noexcept {
    const Imath::V3d across = corner[2] - corner[0], back = corner[3] - corner[1];
    const double diagonal = std::max(across.length(), back.length());
    const Imath::V3d normal = across.cross(back);
    const double length = normal.length();
    return length == 0.0 || std::abs(normal.dot(corner[1] - corner[0])) <= 1e-5 * diagonal * length;
}

/// Whether a walk round the four corners never turns the other way. Corners may coincide, or all lie in one line.
bool is_convex(const std::array<Imath::V3d, 4>& corner) noexcept {
    const Imath::V3d normal = (corner[2] - corner[0]).cross(corner[3] - corner[1]);
    const bool no_area = normal.dot(normal) == 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const Imath::V3d in = corner[(i + 1) % 4] - corner[i], out = corner[(i + 2) % 4] - corner[(i + 1) % 4];
        const Imath::V3d turn = in.cross(out);
        // A bow tie may have no area on the whole, and straight corners may seem to turn by their rounding.
        const double slack = 1e-6 * in.length() * out.length();
        if (no_area ? turn.length() > slack : turn.dot(normal) < -slack * normal.length()) return false;
    }
    return true;
}

void check_patch(const TriangleMesh& mesh, const Patch& patch, std::size_t number, const ParameterList& list) {
    const auto at = [&](std::size_t i) { return Imath::V3d(mesh.position[patch[i]]); };
    const std::array<Imath::V3d, 4> round = {at(0), at(1), at(3), at(2)};
    const bool flat = is_flat(round);
    if (flat && is_convex(round)) return;
    throw SceneError(
        list.place,
        fmt::format("patch {} of shape \"bilinearmesh\", which is not {}", number, flat ? "convex" : "flat"),
        "a flat convex one (others are known to pbrt-v4 and not yet supported here)");
}

}  // namespace

std::optional<ReadShape> read_triangle_mesh(const ParameterList& list, const ShapeFrame& frame,
                                            std::vector<std::string>& warnings) {
    TriangleMesh mesh = read_vertices(list, frame);
    const std::vector<Triangle> triangles = read_faces<3>(list, mesh.position.size());
    return finish_mesh(std::move(mesh), triangles, 1, list, warnings);
}

std::optional<ReadShape> read_bilinear_mesh(const ParameterList& list, const ShapeFrame& frame,
                                            std::vector<std::string>& warnings) {
    TriangleMesh mesh = read_vertices(list, frame);
    const std::vector<Patch> patches = read_faces<4>(list, mesh.position.size());
    std::vector<Triangle> triangles;
    triangles.reserve(2 * patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto& [p00, p10, p01, p11] = patches[i];
        check_patch(mesh, patches[i], i, list);
        triangles.push_back({p00, p10, p11});
        triangles.push_back({p00, p11, p01});
    }
    return finish_mesh(std::move(mesh), triangles, 2, list, warnings);
}

}  // namespace emulsion
