#pragma once
// Reading of PNG files, as a source of pictures whose values are known.

#include <filesystem>
#include <string>
#include <vector>

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

struct PngPicture {
    Image<XYZ> xyz;                       ///< Y = 1 for the white of the file
    std::vector<std::string> notes = {};  ///< what was assumed or left out, one sentence each
};

/// Any PNG: grey, RGB or a palette, of 1 to 16 bits, interlaced or not. Decoded by its sRGB chunk or by its gAMA and
/// cHRM; where both are missing it is taken as sRGB, and that is said, as are an alpha and an ICC profile that were
/// left out. What dithering did stays in. \throws IoError naming what was found if the file is missing, no PNG, damaged
/// or incomplete, has a cICP chunk (which libpng 1.6.39 does not decode, and nothing else says the same), or a gAMA
/// outside [0.2, 10].
[[nodiscard]] PngPicture read_png(const std::filesystem::path& path);

}  // namespace emulsion
