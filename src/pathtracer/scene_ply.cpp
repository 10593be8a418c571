#include "pathtracer/scene_ply.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/error.h"
#include "pathtracer/ply_header.h"
#include "pathtracer/ply_values.h"
#include "pathtracer/scene_geometry.h"

namespace emulsion {

namespace {

/// What of a vertex is kept, by its place in an array of numbers.
constexpr std::size_t kX = 0, kY = 1, kZ = 2, kNx = 3, kNy = 4, kNz = 5, kU = 6, kV = 7, kSlots = 8;

std::optional<std::size_t> place_of(const PlyElement& element, std::string_view name) noexcept {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (element.properties[i].name == name && !element.properties[i].count_type) return i;
    }
    return std::nullopt;
}

/// For each property the slot that it goes to; kSlots: to none.
struct VertexLayout {
    std::vector<std::size_t> slot_of;
    bool has_position = false, has_normal = false, has_uv = false;

    explicit VertexLayout(const PlyElement& vertex) : slot_of(vertex.properties.size(), kSlots) {
        has_position = assign<3>(vertex, {"x", "y", "z"}, kX);
        has_normal = assign<3>(vertex, {"nx", "ny", "nz"}, kNx);
        has_uv = assign<2>(vertex, {"u", "v"}, kU) || assign<2>(vertex, {"s", "t"}, kU) ||
                 assign<2>(vertex, {"texture_u", "texture_v"}, kU) || assign<2>(vertex, {"texture_s", "texture_t"}, kU);
    }

  private:
    template <std::size_t Count>
    bool assign(const PlyElement& vertex, const std::array<std::string_view, Count>& names, std::size_t first_slot) {
        std::array<std::size_t, Count> places{};
        for (std::size_t i = 0; i < Count; ++i) {
            const auto place = place_of(vertex, names[i]);
            if (!place) return false;
            places[i] = *place;
        }
        for (std::size_t i = 0; i < Count; ++i) slot_of[places[i]] = first_slot + i;
        return true;
    }
};

bool is_normal(std::size_t slot) noexcept { return slot >= kNx && slot <= kNz; }

void read_vertices(PlyValues& values, const PlyElement& vertex, PlyMesh& mesh) {
    const VertexLayout layout(vertex);
    if (!layout.has_position) values.fail("vertices without x, y and z", "these properties");
    values.check_room_for(vertex);
    const auto count = static_cast<std::size_t>(vertex.count);
    mesh.position.reserve(count + kRoomBehind);
    if (layout.has_normal) mesh.normal.reserve(count);
    if (layout.has_uv) mesh.uv.reserve(count);

    std::array<float, kSlots> kept{};
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < vertex.properties.size(); ++k) {
            const PlyProperty& property = vertex.properties[k];
            const std::size_t slot = layout.slot_of[k];
            if (slot == kSlots) {
                values.skip(property);
                continue;
            }
            const double value = values.next(property.type);
            const bool fits = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());
            if (!fits && !is_normal(slot)) {
                values.fail(fmt::format("{} for {} of vertex {}", value, property.name, i),
                            "a number that single precision holds");
            }
            kept[slot] = fits ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
        }
        mesh.position.emplace_back(kept[kX], kept[kY], kept[kZ]);
        if (layout.has_uv) mesh.uv.emplace_back(kept[kU], kept[kV]);
        if (!layout.has_normal) continue;
        Imath::V3f normal(kept[kNx], kept[kNy], kept[kNz]);
        if (std::isnan(normal.x) || std::isnan(normal.y) || std::isnan(normal.z)) {
            normal = Imath::V3f(0.0f);
            ++mesh.bad_normals;
        }
        mesh.normal.push_back(normal);
    }
}

std::uint32_t read_index(PlyValues& values, PlyType type, std::uint64_t face, std::uint64_t vertices) {
    const double index = values.next(type);
    if (!(index >= 0.0 && index < static_cast<double>(vertices) && index == std::trunc(index))) {
        values.fail(fmt::format("the index {} in face {}", index, face),
                    vertices == 0 ? std::string("vertices") : fmt::format("one from 0 to {}", vertices - 1));
    }
    return static_cast<std::uint32_t>(index);
}

void read_corners(PlyValues& values, const PlyProperty& list, std::uint64_t face, std::uint64_t vertices,
                  PlyMesh& mesh) {
    const std::uint64_t corners = values.next_count(*list.count_type);
    if (corners != 3 && corners != 4) {
        values.skip(list.type, corners);
        ++mesh.other_faces;
        return;
    }
    std::array<std::uint32_t, 4> index{};
    for (std::size_t k = 0; k < corners; ++k) index[k] = read_index(values, list.type, face, vertices);
    if (corners == 3) {
        mesh.triangle.push_back({index[0], index[1], index[2]});
    } else {
        mesh.patch.push_back({index[0], index[1], index[3], index[2]});
    }
}

void read_faces(PlyValues& values, const PlyElement& face, std::uint64_t vertices, PlyMesh& mesh) {
    const auto is_indices = [](const PlyProperty& property) {
        return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
    };
    const auto indices = std::find_if(face.properties.begin(), face.properties.end(), is_indices);
    if (indices == face.properties.end()) values.fail("faces without vertex_indices", "this list");
    values.check_room_for(face);
    // No more than there is room for, if they are triangles: a count alone must not take memory.
    const std::size_t least = 3 * size_of(indices->type) + size_of(*indices->count_type);
    mesh.triangle.reserve(std::min(static_cast<std::size_t>(face.count), values.room() / least));
    for (std::uint64_t i = 0; i < face.count; ++i) {
        for (auto property = face.properties.begin(); property != face.properties.end(); ++property) {
            if (property == indices) {
                read_corners(values, *property, i, vertices, mesh);
            } else {
                values.skip(*property);
            }
        }
    }
}

}  // namespace

PlyMesh read_ply(const std::filesystem::path& path, std::string_view bytes) {
    const PlyHeader header = read_ply_header(path, bytes);
    PlyValues values(path, bytes, header);
    const PlyElement* const vertex = find_element(header, "vertex");
    const PlyElement* const face = find_element(header, "face");
    if (vertex == nullptr || face == nullptr) {
        throw IoError(path, fmt::format("no element \"{}\" in its header", vertex == nullptr ? "vertex" : "face"));
    }
    if (vertex->count > std::numeric_limits<std::uint32_t>::max()) {
        throw IoError(path, fmt::format("{} vertices, expected at most {}", vertex->count,
                                        std::numeric_limits<std::uint32_t>::max()));
    }
    PlyMesh mesh;
    for (const PlyElement& element : header.elements) {
        if (&element == vertex) {
            read_vertices(values, element, mesh);
        } else if (&element == face) {
            read_faces(values, element, vertex->count, mesh);
        } else {
            values.skip(element);
        }
    }
    return mesh;
}

}  // namespace emulsion
