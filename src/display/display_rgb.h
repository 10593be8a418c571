#pragma once
// From display-relative XYZ (Y = 1 at display white) to linear RGB of a display: (1, 1, 1) is its white, values outside
// [0, 1] are colours that it can't show. Linear: proportional to light, not encoded.

#include <span>
#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/matrix3.h"

namespace emulsion {

/// BT.709 primaries and D65. Source: IEC 61966-2-1:1999.
struct SrgbDisplay {
    static constexpr std::string_view kName = "srgb";
    static constexpr std::string_view kHelp = "BT.709 primaries, D65 white";
    bool operator==(const SrgbDisplay&) const = default;
};

/// All displays; the first is the default.
using Display = std::variant<SrgbDisplay>;

/// Derived from the display's primaries and white. No chromatic adaptation: colours are shown as they are.
[[nodiscard]] Matrix3 rgb_from_xyz(const Display& display);

/// XYZ of the display's white, Y = 1.
[[nodiscard]] XYZd white_xyz(const Display& display);

/// matrix * xyz: the double-precision twin.
[[nodiscard]] RGBd display_rgb(const Matrix3& matrix, const XYZd& xyz) noexcept;

/// rgb[i] = matrix * xyz[i] in single precision, within 1e-6 (|X| + |Y| + |Z|) of the twin; as many of one as of the
/// other. Finite for components below 2^120; NaN stays in its own pixel.
void display_rgb(const Matrix3& matrix, std::span<const XYZ> xyz, std::span<RGB> rgb) noexcept;

}  // namespace emulsion
