#pragma once
// Scene-referred pictures from files of several formats.

#include <filesystem>

#include "film/exr_file.h"
#include "film/scene_picture.h"

namespace emulsion {

/// Reads what the file holds, whatever its name: an OpenEXR picture (read_exr(), without layers), a Radiance picture
/// (read_radiance()), a PFM (read_pfm()), or a PNG (read_png()) as a source of known values, its white taken as 1
/// cd/m^2, which its notes say. \param threads 0: one for each processor \throws IoError if the file is missing, of no
/// such format, damaged or incomplete. \throws std::invalid_argument if threads < 0.
[[nodiscard]] ScenePicture read_picture(const std::filesystem::path& path, int threads);

/// The same with what else an OpenEXR file holds: layers, window and header. Pictures of other formats have none, and
/// are the full frame. \throws as read_picture.
[[nodiscard]] FilmImage read_picture_and_layers(const std::filesystem::path& path, int threads);

}  // namespace emulsion
