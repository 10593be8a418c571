#pragma once
// CIELUV (CIE 1976 L*u*v*). XYZ and white are relative or absolute, but both the same. Components have both signs: for
// the green of sRGB u* is -83.1, for its blue v* is -130.4.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// L* is 100 for white; u* > 0 is reddish, v* > 0 yellowish.
struct Luv {
    double l = 0.0, u = 0.0, v = 0.0;
    bool operator==(const Luv&) const = default;
};

/// The same with u* and v* as chroma C*uv and hue h_uv, in degrees, in [0, 360): see spectrum/hue.h.
struct LchUv {
    double l = 0.0, chroma = 0.0, hue_deg = 0.0;
    bool operator==(const LchUv&) const = default;
};

/// L* as in CIELAB, u* = 13 L* (u' - u'n), v* = 13 L* (v' - v'n), with the CIE 1976 u', v' of colour and white.
/// Black is (0, 0, 0). Negative Y is taken, by the toe of L*. Where Y = 0, u* and v* are 0 whatever X and Z are; where
/// X + 15 Y + 3 Z = 0 otherwise, they are not finite. Source: CIE 15:2004, section 8.2.2; ISO/CIE 11664-5.
[[nodiscard]] Luv luv_from_xyz(const XYZd& xyz, const XYZd& white) noexcept;
/// The inverse, to some 1e-16 / |Y|, as the chromaticity fades with the luminance. L* = 0 is black; not finite there
/// for other u* and v*, nor where v' is 0.
[[nodiscard]] XYZd xyz_from_luv(const Luv& luv, const XYZd& white) noexcept;

[[nodiscard]] LchUv lch_from_luv(const Luv& luv) noexcept;
[[nodiscard]] Luv luv_from_lch(const LchUv& lch) noexcept;

struct LuvSystem {
    static constexpr std::string_view kName = "luv";
    static constexpr std::string_view kHelp = "CIELUV, CIE 1976, relative to the white";
    static constexpr std::string_view kDomain = "Y other than 0, and black";
    static constexpr std::array kComponents = {ColorComponent{"L*", 0.0, 100.0, "", "lightness"},
                                               ColorComponent{"u*", -83.07, 175.1, "", "green to red"},
                                               ColorComponent{"v*", -134.2, 107.5, "", "blue to yellow"}};
    bool operator==(const LuvSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const LuvSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const LuvSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

struct LchUvSystem {
    static constexpr std::string_view kName = "lch-uv";
    static constexpr std::string_view kHelp = "CIELUV with chroma and hue; greys have hue 0";
    static constexpr std::string_view kDomain = "Y other than 0, and black";
    static constexpr std::array kComponents = {ColorComponent{"L*", 0.0, 100.0, "", "lightness"},
                                               ColorComponent{"C*uv", 0.0, 179.1, "", "chroma"},
                                               ColorComponent{"h_uv", 0.0, 360.0, "deg", "hue"}};
    bool operator==(const LchUvSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const LchUvSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const LchUvSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
