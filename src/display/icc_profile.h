#pragma once
// ICC profiles: for encodings that PNG has no shorter words for. Made by Little CMS.

#include <string>

#include "display/color_encoding.h"

namespace emulsion {

/// The bytes of a display profile of version 4: matrix and curves. The matrix goes to D50 by linear Bradford, as ICC
/// wants it, and the profile says so ("chad"). The transfer functions of spectrum/transfer_function.h are ICC's
/// parametric curves, but for Bt709's gap, and any other a table of 4096 points; numbers are rounded to 2^-16. Its date
/// is the start of 2000 and it has no ID, so that the same encoding gives the same bytes. The range is left to others.
/// \throws std::invalid_argument if the primaries lie on one line or the white has no adaptation to D50, and for PQ and
/// HLG, whose white depends on the display.
[[nodiscard]] std::string icc_profile(const ColorEncoding& encoding);

}  // namespace emulsion
