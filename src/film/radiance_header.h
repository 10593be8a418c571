#pragma once
// The lines before the pixels of a Radiance picture.

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string_view>

#include "spectrum/rgb_space.h"

namespace emulsion {

enum class RadianceFormat { rgbe, xyze };

struct RadianceHeader {
    std::optional<RadianceFormat> format;       ///< none: the file doesn't say
    double exposure = 1.0;                      ///< that the values were multiplied by, > 0
    std::array<double, 3> correction{1, 1, 1};  ///< likewise, by component; > 0
    std::optional<RgbSpace> space;              ///< none: the file doesn't say
    /// Scan lines follow one another along the first axis; `rows` is whether that is y. Forward: +X to the right, -Y
    /// downwards, as images are.
    bool rows = true, forward_x = true, forward_y = true;
    int width = 0, height = 0;  ///< 1 to 2^20
    std::size_t begin = 0;      ///< of the pixels
};

/// \throws IoError naming the line, what was found and what was expected.
[[nodiscard]] RadianceHeader read_radiance_header(const std::filesystem::path& path, std::string_view bytes);

}  // namespace emulsion
