#pragma once
// What an EXR is, as its headers say; no pixels are read.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image.h"
#include "film/exr_file.h"

namespace emulsion {

struct ExrChannelInfo {
    std::string name;
    std::string type;  ///< "half", "float" or "uint"
    bool operator==(const ExrChannelInfo&) const = default;
};

struct ExrPartInfo {
    std::string name;         ///< empty if it has none
    std::string compression;  ///< as core/named_value.h prints ExrCompression, without parameters
    PixelBounds data_window;  ///< as in the file
    PixelBounds display_window;
    std::vector<ExrChannelInfo> channels;  ///< in the file's order
    bool operator==(const ExrPartInfo&) const = default;
};

enum class ExrKind {
    film_state,    ///< a film state (film/film_state.h)
    film_picture,  ///< a picture with Emulsion's metadata
    picture,       ///< any other with channels X Y Z or R G B
    other
};

struct ExrInfo {
    ExrKind kind = ExrKind::other;
    std::vector<ExrPartInfo> parts;
    std::size_t picture_part = 0;  ///< the part that read_exr() would read; of `other`, 0
    /// "XYZ"; else the first of exr_space_names() with the primaries and the white of the file, or "R G B of (0.64,
    /// 0.33), (0.3, 0.6), (0.15, 0.06), white (0.3127, 0.329)"; of `other`, empty.
    std::string space;
    FilmMetadata metadata;  ///< of film states and film pictures
    bool operator==(const ExrInfo&) const = default;
};

/// \throws IoError in one line if the file is missing, a folder, no EXR, deep, or has a damaged header.
[[nodiscard]] ExrInfo read_exr_info(const std::filesystem::path& path);

}  // namespace emulsion
