#pragma once
// xyY: chromaticity and luminance. XYZ of any observer, absolute or relative.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// x = X / (X + Y + Z), y = Y / (X + Y + Z), and Y itself.
struct Xyy {
    double x = 0.0, y = 0.0;
    double luminance = 0.0;  ///< Y
    bool operator==(const Xyy&) const = default;
};

/// Black has no chromaticity; by convention it gets that of the white. Not finite where X + Y + Z = 0 otherwise.
/// Source: CIE 15:2004.
[[nodiscard]] Xyy xyy_from_xyz(const XYZd& xyz, const XYZd& white) noexcept;

/// X = x Y / y, Z = (1 - x - y) Y / y. Not finite for y = 0: of colours without luminance only black has an xyY.
[[nodiscard]] XYZd xyz_from_xyy(const Xyy& xyy) noexcept;

struct XyySystem {
    static constexpr std::string_view kName = "xyy";
    static constexpr std::string_view kHelp = "chromaticity x, y and luminance; black has the white's chromaticity";
    static constexpr std::string_view kDomain = "Y other than 0, and black";
    static constexpr std::array kComponents = {ColorComponent{"x", 0.15, 0.64, "", "chromaticity"},
                                               ColorComponent{"y", 0.06, 0.6, "", "chromaticity"},
                                               ColorComponent{"Y", 0.0, 1.0, "", "relative luminance"}};
    bool operator==(const XyySystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const XyySystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const XyySystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
