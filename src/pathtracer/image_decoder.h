#pragma once
// PNG and JPEG pictures by stb_image (https://github.com/nothings/stb), which nothing else includes.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace emulsion {

/// Pixels a picture may have at most; three floats of each are 1.5 GiB.
inline constexpr std::size_t kMaxTexels = std::size_t{1} << 27u;

/// Code values as the file has them, row by row from the top left, not decoded.
struct CodedImage {
    int width = 0, height = 0;
    int channels = 3;        ///< 1: grey, 3: red, green, blue; 4: and alpha
    int largest_code = 255;  ///< or 65535
    std::vector<std::uint16_t> code;
};

/// Grey pictures and those with a palette lose their alpha, as in pbrt-v4.
/// \throws IoError if the bytes are no whole picture, and for one of more than kMaxTexels.
[[nodiscard]] CodedImage decode_png(const std::filesystem::path& path, std::string_view bytes);
[[nodiscard]] CodedImage decode_jpeg(const std::filesystem::path& path, std::string_view bytes);

}  // namespace emulsion
