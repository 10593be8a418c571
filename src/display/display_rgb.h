#pragma once
// From display-relative XYZ (Y = 1 at display white) to the linear signal of a display, RGB: (1, 1, 1) is its white,
// (0, 0, 0) its black with the room's light on it, values outside [0, 1] are colours that it can't show. Linear: its
// steps are proportional to light, not encoded.

#include <span>

#include "core/color.h"
#include "core/matrix3.h"
#include "display/display.h"
#include "display/scene_white.h"

namespace emulsion {

/// rgb = matrix xyz - pedestal.
struct RgbFromXyz {
    Matrix3 matrix;
    double pedestal = 0.0;
    bool operator==(const RgbFromXyz&) const = default;
};

/// Chromatic adaptation, the display's primaries and white, its black and the room's light, in this order.
/// \throws std::invalid_argument if the display or the white isn't valid.
[[nodiscard]] RgbFromXyz rgb_from_xyz(const Display& display, const SceneWhite& white = {});

/// The double-precision twin.
[[nodiscard]] RGBd display_rgb(const RgbFromXyz& conversion, const XYZd& xyz) noexcept;

/// The same in single precision, within 1e-6 gain (|X| + |Y| + |Z|) + 1e-7 pedestal of the twin, the gain being that of
/// signal_scale(); as many of one as of the other. Finite for components below 2^120 / gain; NaN stays in its own
/// pixel.
void display_rgb(const RgbFromXyz& conversion, std::span<const XYZ> xyz, std::span<RGB> rgb) noexcept;

}  // namespace emulsion
