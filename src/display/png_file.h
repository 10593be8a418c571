#pragma once
// PNG files.

#include <filesystem>
#include <string>
#include <vector>

#include "core/image.h"
#include "display/code_value.h"
#include "display/color_encoding.h"
#include "display/png_compression.h"

namespace emulsion {

/// A text chunk: tEXt if the text is ASCII, iTXt in UTF-8 otherwise.
struct PngText {
    std::string keyword;  ///< 1 to 79 printable ASCII characters; single spaces, and none at the ends
    std::string text;     ///< UTF-8, without '\0'
    bool operator==(const PngText&) const = default;
};

struct PngOptions {
    int bits = 8;                  ///< of the picture's codes; 1 to 16, 8 to 16 in the narrow range
    ColorEncoding color = {};      ///< what the codes mean
    int level = kDefaultPngLevel;  ///< of compression, 0 to 9; see png_compression.h
    std::vector<PngText> text = {};
};

/// For saying so before the work.
/// \throws std::invalid_argument naming what is out of its range, or can't be said in a PNG: see png_color().
void validate(const PngOptions& options);

/// Writes RGB of 8 bits, or of 16 where codes have more than 8; codes of other than 8 or 16 bits are spread over all
/// of them (in the narrow range: shifted, as its black and white are at 16/256 and 235/256 for any number of bits), and
/// an sBIT chunk tells how many bits they had. What they mean is in the chunks of png_color(). The same picture and
/// options give the same bytes. The file appears whole or not at all. \throws IoError{path, reason} if the file can't
/// be written; then an older file of that name is still there. \throws std::invalid_argument if the picture is empty, a
/// code has more than `bits`, and as validate().
void write_png(const std::filesystem::path& path, const Image<CodeRGB>& image, const PngOptions& options = {});

}  // namespace emulsion
