#include "pathtracer/scene_mesh.h"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "pathtracer/bilinear.h"
#include "pathtracer/scene_ply.h"
#include "pathtracer/scene_transform.h"

namespace emulsion {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Patch = std::array<std::uint32_t, 4>;  // p00 p10 p01 p11

constexpr double kMostFloat = std::numeric_limits<float>::max();
constexpr std::string_view kHeld = "coordinates that single precision holds";

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
void read_coordinates(const ParameterList& list, const ShapeFrame& frame, MeshVertices& mesh) {
    const std::size_t vertices = mesh.position.size();
    if (const SceneParameter* const uv = per_vertex(list, "uv", 2, vertices)) {
        mesh.uv.reserve(vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            const double u = uv->numbers[2 * i], v = uv->numbers[2 * i + 1];
            if (!(std::abs(u) <= kMostFloat && std::abs(v) <= kMostFloat)) {
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
            mesh.tangent.push_back(single_precision(world, kMostFloat, kHeld, *tangents, i));
        }
    }
}

bool flips_normal(const ShapeFrame& frame) noexcept {
    return (frame.orientation == Orientation::reversed) != swaps_handedness(frame.world_from_object);
}

/// Takes normals to world space, and turns them round with the orientation.
Imath::M44d matrix_of_normals(const ShapeFrame& frame, const SourcePlace& place) {
    const std::optional<Imath::M44d> matrix = normal_matrix(frame.world_from_object);
    if (!matrix) throw SceneError(place, "normals under a transformation without inverse", "another one");
    return frame.orientation == Orientation::reversed ? *matrix * -1.0 : *matrix;
}

/// Positions, normals and coordinates in world space.
MeshVertices read_vertices(const ParameterList& list, const ShapeFrame& frame) {
    const SceneParameter* const positions = find_parameter(list, "P");
    if (positions == nullptr) {
        throw SceneError(list.place, fmt::format("shape \"{}\" without positions", list.owner), "a parameter \"P\"");
    }
    const std::size_t vertices = positions->numbers.size() / 3;
    MeshVertices mesh;
    mesh.flip_normal = flips_normal(frame);
    mesh.position.reserve(vertices + kRoomBehind);
    for (std::size_t i = 0; i < vertices; ++i) {
        const Imath::V3d world = transform_point(frame.world_from_object, point_of(positions->numbers, i));
        mesh.position.push_back(single_precision(world, kReach, kWithinReach, *positions, i));
    }
    read_coordinates(list, frame, mesh);
    if (const SceneParameter* const normals = per_vertex(list, "N", 3, vertices)) {
        const Imath::M44d matrix = matrix_of_normals(frame, normals->place);
        mesh.normal.reserve(vertices);
        for (std::size_t i = 0; i < vertices; ++i) {
            const Imath::V3d world = transform_vector(matrix, point_of(normals->numbers, i));
            mesh.normal.push_back(single_precision(world, kMostFloat, kHeld, *normals, i));
        }
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

/// Twice the area of the triangle.
double double_area(const std::vector<Imath::V3f>& position, const Triangle& triangle) noexcept {
    const Imath::V3d p0(position[triangle[0]]);
    return (Imath::V3d(position[triangle[1]]) - p0).cross(Imath::V3d(position[triangle[2]]) - p0).length();
}

void warn_of_dropped(std::size_t dropped, std::size_t all, std::string_view what, const ParameterList& list,
                     ShapeReading& reading) {
    if (dropped == 0) return;
    reading.warnings.add(list.place, fmt::format("{} without area, left out: {} of {}", what, dropped, all));
}

void add_triangles(MeshVertices vertices, std::vector<Triangle> triangles, const ParameterList& list,
                   ShapeReading& reading, std::vector<Geometry>& shapes) {
    TriangleMesh mesh{std::move(vertices), std::move(triangles)};
    const std::size_t all = mesh.triangle.size();
    std::erase_if(mesh.triangle, [&](const Triangle& t) { return !(double_area(mesh.position, t) > 0.0); });
    warn_of_dropped(all - mesh.triangle.size(), all, "triangles", list, reading);
    if (!mesh.triangle.empty()) shapes.emplace_back(std::move(mesh));
}

void add_patches(MeshVertices vertices, std::vector<Patch> patches, const ParameterList& list, ShapeReading& reading,
                 std::vector<Geometry>& shapes) {
    BilinearMesh mesh{std::move(vertices), std::move(patches)};
    const std::size_t all = mesh.patch.size();
    std::erase_if(mesh.patch, [&](const Patch& p) {
        return !(double_area(mesh.position, {p[0], p[1], p[3]}) > 0.0) &&
               !(double_area(mesh.position, {p[0], p[3], p[2]}) > 0.0);
    });
    warn_of_dropped(all - mesh.patch.size(), all, "patches", list, reading);
    mesh.flat = true;
    for (std::uint32_t i = 0; mesh.flat && i < mesh.patch.size(); ++i) {
        mesh.flat = is_flat_and_convex(BilinearPatch(mesh, i));
    }
    if (!mesh.patch.empty()) shapes.emplace_back(std::move(mesh));
}

// --- PLY

/// `v` mapped, or an error about vertex number `index`.
Imath::V3f mapped(const Imath::V3d& world, double most, std::string_view expected, const SceneParameter& file,
                  std::size_t index) {
    const bool fits = std::abs(world.x) <= most && std::abs(world.y) <= most && std::abs(world.z) <= most;
    if (fits) return Imath::V3f(world);
    throw SceneError(file.first_value,
                     fmt::format("({:g}, {:g}, {:g}) in world space for vertex {} of {}", world.x, world.y, world.z,
                                 index, quote(file.strings.front())),
                     std::string(expected));
}

/// Moves positions and normals of a file into world space, where they lie.
MeshVertices to_world(PlyMesh& ply, const ShapeFrame& frame, const SceneParameter& file) {
    for (std::size_t i = 0; i < ply.position.size(); ++i) {
        const Imath::V3d world = transform_point(frame.world_from_object, Imath::V3d(ply.position[i]));
        ply.position[i] = mapped(world, kReach, kWithinReach, file, i);
    }
    if (!ply.normal.empty()) {
        const Imath::M44d matrix = matrix_of_normals(frame, file.place);
        for (std::size_t i = 0; i < ply.normal.size(); ++i) {
            ply.normal[i] = mapped(transform_vector(matrix, Imath::V3d(ply.normal[i])), kMostFloat, kHeld, file, i);
        }
    }
    return {std::move(ply.position), std::move(ply.normal), std::move(ply.uv), {}, flips_normal(frame)};
}

PlyMesh read_file(const SceneParameter& file, ShapeReading& reading) {
    const std::string& name = file.strings.front();
    const std::string bytes = reading.files.read(file.first_value, name);
    try {
        return read_ply(reading.files.path_of(name), bytes);
    } catch (const IoError& error) {
        throw SceneError(file.first_value, fmt::format("the file {} ({})", quote(name), error.reason()),
                         "a PLY file that can be read");
    }
}

}  // namespace

std::vector<Geometry> read_triangle_mesh(const ParameterList& list, const ShapeFrame& frame, ShapeReading& reading) {
    MeshVertices vertices = read_vertices(list, frame);
    std::vector<Triangle> triangles = read_faces<3>(list, vertices.position.size());
    std::vector<Geometry> shapes;
    add_triangles(std::move(vertices), std::move(triangles), list, reading, shapes);
    return shapes;
}

std::vector<Geometry> read_bilinear_mesh(const ParameterList& list, const ShapeFrame& frame, ShapeReading& reading) {
    MeshVertices vertices = read_vertices(list, frame);
    std::vector<Patch> patches = read_faces<4>(list, vertices.position.size());
    std::vector<Geometry> shapes;
    add_patches(std::move(vertices), std::move(patches), list, reading, shapes);
    return shapes;
}

std::vector<Geometry> read_ply_mesh(const ParameterList& list, const ShapeFrame& frame, ShapeReading& reading) {
    const SceneParameter* const file = find_parameter(list, "filename");
    if (file == nullptr) {
        throw SceneError(list.place, fmt::format("shape \"{}\" without a file", list.owner),
                         "a parameter \"filename\"");
    }
    PlyMesh ply = read_file(*file, reading);
    const auto warn_of = [&](std::size_t count, std::string_view what) {
        if (count == 0) return;
        reading.warnings.add(file->first_value, fmt::format("{} {}: {}", quote(file->strings.front()), what, count));
    };
    warn_of(ply.other_faces, "has faces of neither three nor four corners, left out");
    warn_of(ply.bad_normals, "has normals that are no numbers, taken as unknown");

    std::vector<Geometry> shapes;
    MeshVertices vertices = to_world(ply, frame, *file);
    const bool has_triangles = !ply.triangle.empty(), has_patches = !ply.patch.empty();
    if (!has_triangles && !has_patches) warn_of(1, "has no faces; shapes without any");
    if (has_triangles && has_patches) add_patches(vertices, std::move(ply.patch), list, reading, shapes);
    if (has_triangles) {
        add_triangles(std::move(vertices), std::move(ply.triangle), list, reading, shapes);
    } else if (has_patches) {
        add_patches(std::move(vertices), std::move(ply.patch), list, reading, shapes);
    }
    return shapes;
}

}  // namespace emulsion
