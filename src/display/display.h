#pragma once
// The display that a picture is made for.

#include <string>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "display/custom_display.h"
#include "display/display_light.h"
#include "display/display_presets.h"
#include "spectrum/rgb_space.h"
#include "spectrum/transfer_function.h"

namespace emulsion {

/// All displays; the first is the default.
using Display = std::variant<SrgbDisplay, DisplayP3, Rec2020Display, AdobeRgbDisplay, DciP3Display, CrtDisplay,
                             Hdr10Display, HlgDisplay, CustomDisplay>;

/// \throws std::invalid_argument naming display, parameter, value and range; as check_triangle() and
/// check_white() for measured primaries.
void validate(const Display& display);

/// Primaries and white.
[[nodiscard]] RgbSpace rgb_space(const Display& display);

/// The transfer function that the display undoes: "transfer=own". BT.1886 has the display's black and peak in it.
[[nodiscard]] TransferFunction own_transfer(const Display& display) noexcept;

[[nodiscard]] DisplayLight light_of(const Display& display) noexcept;

/// XYZ of the display's white, Y = 1.
[[nodiscard]] XYZd white_xyz(const Display& display);

}  // namespace emulsion
