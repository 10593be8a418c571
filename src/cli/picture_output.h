#pragma once
// What `emulsion develop -o` writes, by the ending of its name.

#include <filesystem>
#include <string>

#include "core/color.h"
#include "core/image.h"

namespace emulsion::cli {

enum class PictureFormat {
    png,      ///< developed
    pfm,      ///< scene-referred, as tone mapping would get it
    radiance  ///< likewise
};

/// Of a name ending in .png, .pfm or .hdr, of which ends_in_picture() makes sure.
[[nodiscard]] PictureFormat picture_format(const std::filesystem::path& name);

/// For CLI::Option::check: a name ending in .png, .pfm or .hdr.
[[nodiscard]] std::string ends_in_picture(const std::string& name);

/// What bloom and vision gave, without any stage behind them: linear Rec. 709 in cd/m^2 as a PFM or a Radiance picture.
/// Warns of what the format could not hold. \throws IoError if the file can't be written.
void write_scene_referred(const Image<XYZ>& scene, const std::filesystem::path& path);

}  // namespace emulsion::cli
