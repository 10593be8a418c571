#pragma once
// PNG files; the one user of libpng.

#include <filesystem>
#include <string>
#include <vector>

#include "core/image.h"
#include "display/code_value.h"
#include "display/png_compression.h"

namespace emulsion {

/// A text chunk: tEXt if the text is ASCII, iTXt in UTF-8 otherwise.
struct PngText {
    std::string keyword;  ///< 1 to 79 printable ASCII characters; single spaces, and none at the ends
    std::string text;     ///< UTF-8, without '\0'
    bool operator==(const PngText&) const = default;
};

struct PngOptions {
    int bits = 8;                  ///< of the picture's codes, full range; 1 to 16
    int level = kDefaultPngLevel;  ///< of compression, 0 to 9; see png_compression.h
    std::vector<PngText> text = {};
};

/// Writes RGB of 8 bits, or of 16 where codes have more than 8; codes of other than 8 or 16 bits are spread over all
/// of them, and an sBIT chunk tells how many bits they had. sRGB-encoded, with an sRGB chunk (intent: relative
/// colorimetric, since the picture has been brought into the gamut on purpose and is to be shown as it is) and the
/// matching gAMA and cHRM. The same picture and options give the same bytes. The file appears whole or not at all.
/// \throws IoError{path, reason} if the file can't be written; then an older file of that name is still there.
/// \throws std::invalid_argument if the picture is empty, a code has more than `bits`, or a keyword, a text, the bits
/// or the level are not as above.
void write_png(const std::filesystem::path& path, const Image<CodeRGB>& image, const PngOptions& options = {});

}  // namespace emulsion
