#pragma once
// XYZ itself, and RGB: the linear RGB of the context's space, and the encoded one of its transfer function.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_context.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// Source: CIE 15:2004.
struct XyzSystem {
    static constexpr std::string_view kName = "xyz";
    static constexpr std::string_view kHelp = "CIE tristimulus values";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"X", 0.0, 0.9505, "", "relative"},
                                               ColorComponent{"Y", 0.0, 1.0, "", "relative luminance"},
                                               ColorComponent{"Z", 0.0, 1.09, "", "relative"}};
    bool operator==(const XyzSystem&) const = default;
};

/// RGB = M^-1 XYZ, with the columns of M the primaries, scaled to sum to the white: see spectrum/rgb_space.h.
/// Source: SMPTE RP 177:1993.
struct LinearRgbSystem {
    static constexpr std::string_view kName = "rgb";
    static constexpr std::string_view kHelp = "linear RGB, proportional to light";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"R", 0.0, 1.0, "", "red"},
                                               ColorComponent{"G", 0.0, 1.0, "", "green"},
                                               ColorComponent{"B", 0.0, 1.0, "", "blue"}};
    bool operator==(const LinearRgbSystem&) const = default;
};

/// Each component of linear RGB, encoded: see spectrum/transfer_function.h.
struct EncodedRgbSystem {
    static constexpr std::string_view kName = "encoded-rgb";
    static constexpr std::string_view kHelp = "RGB through the transfer function, as in most files";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"R'", 0.0, 1.0, "", "red"},
                                               ColorComponent{"G'", 0.0, 1.0, "", "green"},
                                               ColorComponent{"B'", 0.0, 1.0, "", "blue"}};
    bool operator==(const EncodedRgbSystem&) const = default;
};

[[nodiscard]] inline ColorValues from_xyz(const XyzSystem& /*system*/, const XYZd& xyz,
                                          const ColorContext& /*context*/) noexcept {
    return {{xyz.x, xyz.y, xyz.z}};
}
[[nodiscard]] inline XYZd to_xyz(const XyzSystem& /*system*/, const ColorValues& color,
                                 const ColorContext& /*context*/) noexcept {
    return {color.value[0], color.value[1], color.value[2]};
}

[[nodiscard]] inline ColorValues from_xyz(const LinearRgbSystem& /*system*/, const XYZd& xyz,
                                          const ColorContext& context) noexcept {
    const RGBd rgb = context.linear_from_xyz(xyz);
    return {{rgb.r, rgb.g, rgb.b}};
}
[[nodiscard]] inline XYZd to_xyz(const LinearRgbSystem& /*system*/, const ColorValues& color,
                                 const ColorContext& context) noexcept {
    return context.xyz_from_linear({color.value[0], color.value[1], color.value[2]});
}

[[nodiscard]] inline ColorValues from_xyz(const EncodedRgbSystem& /*system*/, const XYZd& xyz,
                                          const ColorContext& context) noexcept {
    const RGBd rgb = context.encoded_from_xyz(xyz);
    return {{rgb.r, rgb.g, rgb.b}};
}
[[nodiscard]] inline XYZd to_xyz(const EncodedRgbSystem& /*system*/, const ColorValues& color,
                                 const ColorContext& context) noexcept {
    return context.xyz_from_encoded({color.value[0], color.value[1], color.value[2]});
}

}  // namespace emulsion
