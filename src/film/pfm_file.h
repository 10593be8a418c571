#pragma once
// Portable float maps: linear RGB or grey in single precision, scene-referred. Rows stand in the file from the bottom
// up. Source: P. Debevec, "PFM Portable FloatMap Image Format", 2001.

#include <filesystem>

#include "film/scene_picture.h"

namespace emulsion {

/// Three channels of linear Rec. 709, little endian, scale -1, from XYZ with Y in cd/m^2: every value as it is, NaN and
/// negative ones too, each rounded once. The file appears whole or not at all.
/// \throws IoError if it can't be written.
/// \throws std::invalid_argument if the picture is empty or the white luminance out of its range.
void write_pfm(const std::filesystem::path& path, const Image<XYZ>& xyz, const SceneWriteOptions& options = {});

/// Colour or grey of both byte orders; grey is an amount of white. Assumed, and said in the notes: Rec. 709, and 1
/// cd/m^2 for 1. A scale other than 1 and -1 is not applied, as programs disagree on what it means, and bytes behind
/// the picture are left out; both are said.
/// \throws IoError naming the place, what was found and what was expected.
[[nodiscard]] ScenePicture read_pfm(const std::filesystem::path& path);

}  // namespace emulsion
