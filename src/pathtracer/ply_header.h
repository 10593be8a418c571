#pragma once
// The header of a PLY file: which elements follow, and how their properties are stored.
//
//   header   = "ply" { line } "end_header", each at the end of its line
//   line     = "format" ("ascii" | "binary_little_endian" | "binary_big_endian") "1.0"
//            | "comment" ... | "obj_info" ...
//            | "element" name count
//            | "property" type name | "property" "list" type type name   (of the element above)
// Lines end as the first one does: with \n, \r\n or \r.
// Source: Turk, "The PLY Polygon File Format", 1994.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace emulsion {

enum class PlyFormat { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of a value in the binary formats.
[[nodiscard]] std::size_t size_of(PlyType type) noexcept;

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type = std::nullopt;  ///< set: a list, with a count of this type before its values
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t body_offset = 0;  ///< bytes from the start of the file to the first element
};

/// \throws IoError naming `path` and the line.
[[nodiscard]] PlyHeader read_ply_header(const std::filesystem::path& path, std::string_view bytes);

/// The element of that name; nullptr if there is none.
[[nodiscard]] const PlyElement* find_element(const PlyHeader& header, std::string_view name) noexcept;

}  // namespace emulsion
