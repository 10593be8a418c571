#pragma once
// CIE 1964 U*V*W* (spectrum/cie_1964_uvw.h) as a colour system.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/cie_1964_uvw.h"
#include "spectrum/color_context.h"
#include "spectrum/color_values.h"

namespace emulsion {

struct UvwSystem {
    static constexpr std::string_view kName = "uvw";
    static constexpr std::string_view kHelp = "uniform space of CIE 1964, relative to the white; superseded by luv";
    static constexpr std::string_view kDomain = "Y other than 0 and 0.003144 (where W* = 0), and black";
    static constexpr std::array kComponents = {ColorComponent{"U*", -82.16, 171.9, "", "green to red"},
                                               ColorComponent{"V*", -87.18, 70.83, "", "blue to yellow"},
                                               ColorComponent{"W*", -17.0, 99.04, "", "lightness"}};
    bool operator==(const UvwSystem&) const = default;
};
[[nodiscard]] inline ColorValues from_xyz(const UvwSystem& /*system*/, const XYZd& xyz,
                                          const ColorContext& context) noexcept {
    const Cie1964Uvw uvw = uvw_from_xyz(xyz, context.white());
    return {{uvw.u, uvw.v, uvw.w}};
}
[[nodiscard]] inline XYZd to_xyz(const UvwSystem& /*system*/, const ColorValues& color,
                                 const ColorContext& context) noexcept {
    return xyz_from_uvw({color.value[0], color.value[1], color.value[2]}, context.white());
}

}  // namespace emulsion
