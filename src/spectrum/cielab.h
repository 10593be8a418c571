#pragma once
// CIELAB (CIE 1976 L*a*b*); colour differences in it are in spectrum/color_difference.h. XYZ and white are relative or
// absolute, but both the same.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// L* is 100 for white; a* > 0 is reddish, b* > 0 yellowish.
struct Lab {
    double l = 0.0, a = 0.0, b = 0.0;
    bool operator==(const Lab&) const = default;
};

/// The same with a* and b* as chroma C*ab and hue h_ab, in degrees, in [0, 360): see spectrum/hue.h.
struct LchAb {
    double l = 0.0, chroma = 0.0, hue_deg = 0.0;
    bool operator==(const LchAb&) const = default;
};

/// L* = 116 f(Y/Yn) - 16, a* = 500 (f(X/Xn) - f(Y/Yn)), b* = 200 (f(Y/Yn) - f(Z/Zn)); f(t) = cbrt(t) above (6/29)^3,
/// and below it the straight line that continues it with the same slope, (29/6)^2 t / 3 + 4/29. The line also takes
/// negative XYZ, so that every XYZ has a Lab. Source: CIE 15:2004, section 8.2.1; ISO/CIE 11664-4.
[[nodiscard]] Lab lab_from_xyz(const XYZd& xyz, const XYZd& white) noexcept;
/// The inverse, for every Lab; negative L* is a negative Y. Source: CIE 15:2004.
[[nodiscard]] XYZd xyz_from_lab(const Lab& lab, const XYZd& white) noexcept;

[[nodiscard]] LchAb lch_from_lab(const Lab& lab) noexcept;
[[nodiscard]] Lab lab_from_lch(const LchAb& lch) noexcept;

/// L* of a luminance that is relative to the white's; also that of CIELUV.
[[nodiscard]] double cie_lightness(double relative_luminance) noexcept;
/// The inverse.
[[nodiscard]] double relative_luminance_of(double lightness) noexcept;

struct LabSystem {
    static constexpr std::string_view kName = "lab";
    static constexpr std::string_view kHelp = "CIELAB, CIE 1976, relative to the white";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L*", 0.0, 100.0, "", "lightness"},
                                               ColorComponent{"a*", -86.19, 98.24, "", "green to red"},
                                               ColorComponent{"b*", -107.9, 94.49, "", "blue to yellow"}};
    bool operator==(const LabSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const LabSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const LabSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

struct LchAbSystem {
    static constexpr std::string_view kName = "lch-ab";
    static constexpr std::string_view kHelp = "CIELAB with chroma and hue; greys have hue 0";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L*", 0.0, 100.0, "", "lightness"},
                                               ColorComponent{"C*ab", 0.0, 133.9, "", "chroma"},
                                               ColorComponent{"h_ab", 0.0, 360.0, "deg", "hue"}};
    bool operator==(const LchAbSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const LchAbSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const LchAbSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
