#pragma once
// HSL (also called HLS), of encoded RGB. Lightness is the middle of the greatest and the least of R'G'B': no luminance.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

struct Hsl {
    double hue_deg = 0.0;     ///< in [0, 360): 0 red, 120 green, 240 blue; 0 for greys
    double saturation = 0.0;  ///< 0 for greys, 1 on the faces of the cube
    double lightness = 0.0;   ///< (max + min) / 2
    bool operator==(const Hsl&) const = default;
};

/// L = (max + min) / 2, S = (max - min) / (1 - |2L - 1|), H as in HSV.
/// Within [0, 1]^3 all ranges are as above. The formulas go on outside, and stay invertible: S > 1 where a component
/// leaves [0, 1], and S < 0 where L does. Greys have S = 0; for others with L = 0 or L = 1 exactly, S is infinite. NaN
/// in one component is NaN in all. CSS Color 4 avoids negative S by turning the hue; we keep the plain formula. Source:
/// Joblove & Greenberg, "Color spaces for computer graphics", SIGGRAPH 1978.
[[nodiscard]] Hsl hsl_from_rgb(const RGBd& encoded) noexcept;

/// The inverse. Any hue, also outside [0, 360); NaN for an infinite saturation.
[[nodiscard]] RGBd rgb_from_hsl(const Hsl& hsl) noexcept;

struct HslSystem {
    static constexpr std::string_view kName = "hsl";
    static constexpr std::string_view kHelp = "hue, saturation and lightness of encoded RGB";
    static constexpr std::string_view kDomain = "all but max + min of R'G'B' = 0 or 2 with a colour";
    static constexpr std::array kComponents = {ColorComponent{"H", 0.0, 360.0, "deg", "hue"},
                                               ColorComponent{"S", 0.0, 1.0, "", "saturation"},
                                               ColorComponent{"L", 0.0, 1.0, "", "middle of max and min"}};
    bool operator==(const HslSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const HslSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const HslSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
