#pragma once
// PNG files for tests, byte by byte: pixels are stored, not compressed, so that no library is asked.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace emulsion::testing {

/// A chunk with its length and check sum.
[[nodiscard]] std::string png_chunk(std::string_view type, std::string_view data);

struct PngFormat {
    std::uint32_t width = 1, height = 1;
    int bits = 8;         ///< 8 or 16
    int colour_type = 2;  ///< 0: grey, 2: RGB, 3: palette (of `palette`), 4: grey and alpha, 6: RGB and alpha
    std::string palette = {};
};

/// Codes row by row from the top, all components of a pixel after one another. There may be fewer than the size says.
[[nodiscard]] std::string png_bytes(const PngFormat& format, std::span<const int> codes);

}  // namespace emulsion::testing
