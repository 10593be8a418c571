#pragma once
// What gamut mappers have to know of a display.

#include "core/color.h"
#include "core/matrix3.h"
#include "display/display.h"

namespace emulsion {

/// Linear RGB of the light that the display shows, 1 for its white as it is seen, against luminance, against the cone
/// responses of Oklab, and against the display's signal. Greys are greys in all: RGB (v, v, v) has luminance v and the
/// responses (v, v, v).
struct DisplayGamut {
    RGBd luminance;           ///< of each primary; they add up to 1
    Matrix3 cones_from_rgb;   ///< Oklab's matrix M1, each response relative to that to the display's white
    Matrix3 rgb_from_cones;   ///< its inverse
    double light_span = 1.0;  ///< light of signal 1 less that of signal 0
    double dark_light = 0.0;  ///< light of signal 0, of its black and of the room; 1 - light_span
    bool operator==(const DisplayGamut&) const = default;
};

/// Light of a component of the signal, and back.
[[nodiscard]] constexpr double light_of(const DisplayGamut& gamut, double signal) noexcept {
    return gamut.light_span * signal + gamut.dark_light;
}
[[nodiscard]] constexpr double signal_of(const DisplayGamut& gamut, double light) noexcept {
    return (light - gamut.dark_light) / gamut.light_span;
}

/// Dividing the responses by those to the white adapts it to Oklab's own, which is D65.
/// \throws std::invalid_argument if the display isn't valid.
[[nodiscard]] DisplayGamut display_gamut(const Display& display);

}  // namespace emulsion
