#pragma once
// Text in pictures: small labels.

#include <string_view>

#include "core/image.h"
#include "display/code_value.h"

namespace emulsion {

inline constexpr int kLabelHeight_px = 9;   ///< of a letter at scale 1; those that go below the line included
inline constexpr int kLabelAdvance_px = 6;  ///< from a letter to the next at scale 1

/// Draws `text` with its upper left corner at (x, y), in letters of 5 x 9 pixels times `scale`, 1 or more. Small
/// letters, digits and "-+.:=,/ " are known; others come out as an empty box. What lies outside of the image is left
/// out.
void draw_label(ImageView<CodeRGB> image, int x, int y, std::string_view text, const CodeRGB& color, int scale);

}  // namespace emulsion
