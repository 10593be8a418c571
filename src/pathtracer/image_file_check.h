#pragma once
// Whether PNG and JPEG files are whole, as far as that can be told without decoding them. Decoders take damage that
// they don't notice for pixels; stb_image notices little of it, and trusts some numbers that it should not.

#include <filesystem>
#include <string_view>

namespace emulsion {

/// Follows the chunks from the signature to IEND; each must have its check sum.
/// Source: W3C, "Portable Network Graphics (PNG) Specification", 2nd edition, section 5.
/// \throws IoError naming the byte, what was found and what was expected.
void check_png(const std::filesystem::path& path, std::string_view bytes);

/// Follows the segments from SOI to EOI, over the coded data of all scans. Huffman tables must have at most 256 codes:
/// stb_image (2.27, of Debian 12) writes past the end of its own for more.
/// Source: ITU-T T.81, annex B.
/// \throws IoError likewise.
void check_jpeg(const std::filesystem::path& path, std::string_view bytes);

}  // namespace emulsion
