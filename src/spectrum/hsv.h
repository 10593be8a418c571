#pragma once
// HSV (also called HSB), of encoded RGB. Value is the greatest of R'G'B': no lightness, and no luminance.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

struct Hsv {
    double hue_deg = 0.0;     ///< in [0, 360): 0 red, 120 green, 240 blue; 0 for greys
    double saturation = 0.0;  ///< 0 for greys, 1 for colours without one of R', G', B'
    double value = 0.0;       ///< max(R', G', B')
    bool operator==(const Hsv&) const = default;
};

/// V = max, S = (max - min) / max, H by the sector of the greatest and the distance of the other two.
/// Within [0, 1]^3 all ranges are as above. The formulas go on outside, and stay invertible: S > 1 where the least is
/// negative, and S < 0 where all are (V < 0). Black has S = 0; only where max = 0 above a negative component does S
/// have no value: it is infinite. NaN in one component is NaN in all.
/// Source: Smith, "Color gamut transform pairs", SIGGRAPH 1978.
[[nodiscard]] Hsv hsv_from_rgb(const RGBd& encoded) noexcept;

/// The inverse. Any hue, also outside [0, 360); NaN for an infinite saturation.
[[nodiscard]] RGBd rgb_from_hsv(const Hsv& hsv) noexcept;

/// In [0, 360): 60 degrees times the sector of the hexagon that RGB is in, plus the place in the sector; 0 for greys.
/// The hue of HSV as well as of HSL.
[[nodiscard]] double hexagon_hue_deg(const RGBd& rgb) noexcept;
/// The RGB of this hue whose components have the given least and greatest value.
[[nodiscard]] RGBd rgb_of_hexagon_hue(double hue_deg, double least, double greatest) noexcept;

struct HsvSystem {
    static constexpr std::string_view kName = "hsv";
    static constexpr std::string_view kHelp = "hue, saturation and value of encoded RGB";
    static constexpr std::string_view kDomain = "all but max(R', G', B') = 0 with another negative";
    static constexpr std::array kComponents = {ColorComponent{"H", 0.0, 360.0, "deg", "hue"},
                                               ColorComponent{"S", 0.0, 1.0, "", "saturation"},
                                               ColorComponent{"V", 0.0, 1.0, "", "greatest of R'G'B'"}};
    bool operator==(const HsvSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const HsvSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const HsvSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
