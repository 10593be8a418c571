#pragma once
// What gamut mappers have to know of a display.

#include "core/color.h"
#include "core/matrix3.h"
#include "display/display.h"

namespace emulsion {

/// Linear RGB of the display against luminance, and against the cone responses of Oklab. Greys are greys in all three:
/// RGB (v, v, v) has luminance v and the responses (v, v, v).
struct DisplayGamut {
    RGBd luminance;          ///< of each primary; they add up to 1
    Matrix3 cones_from_rgb;  ///< Oklab's matrix M1, each response relative to that to the display's white
    Matrix3 rgb_from_cones;  ///< its inverse
    bool operator==(const DisplayGamut&) const = default;
};

/// Dividing the responses by those to the white adapts it to Oklab's own, which is D65.
/// \throws std::invalid_argument if the display isn't valid, or a response to its white isn't positive.
[[nodiscard]] DisplayGamut display_gamut(const Display& display);

}  // namespace emulsion
