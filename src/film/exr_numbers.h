#pragma once
// An EXR file as numbers, for those to whom it is no picture in cd/m^2: textures of renderers.

#include <filesystem>
#include <optional>
#include <vector>

#include "film/film_picture.h"
#include "spectrum/rgb_space.h"

namespace emulsion {

struct ExrNumbers {
    /// R, G and B of the first part that has all three, and A if there is one; else the only channel of the first part;
    /// else none. All have the data window's size.
    std::vector<FloatChannel> channels;
    std::optional<RgbSpace> space;  ///< by the chromaticities of the header; unset if it has none
};

/// The numbers as they are: whiteLuminance has no effect.
/// \throws IoError as read_exr(), and if a channel that would be read holds whole numbers or is subsampled.
[[nodiscard]] ExrNumbers read_exr_numbers(const std::filesystem::path& path);

}  // namespace emulsion
