#pragma once
// Y'IQ of NTSC, of encoded RGB: Y'UV (spectrum/yuv.h) turned by 33 degrees, so that I is the axis from orange to blue,
// along which the eye sees most detail.

#include <array>
#include <string_view>

#include "core/color.h"
#include "spectrum/color_values.h"

namespace emulsion {

struct Yiq {
    double luma = 0.0;  ///< Y', 0 black, 1 white
    double i = 0.0;     ///< 0 for greys, within 0.596; > 0 orange
    double q = 0.0;     ///< 0 for greys, within 0.523; > 0 purple
    bool operator==(const Yiq&) const = default;
};

inline constexpr double kYiqTurn_deg = 33.0;

/// I = V cos 33 - U sin 33, Q = V sin 33 + U cos 33 (degrees), for every RGB. The matrix
/// that this gives is the one in print, 0.595716 -0.274453 -0.321263 / 0.211456 -0.522591 0.311135, but for its last
/// digits. Source: SMPTE 170M-2004.
[[nodiscard]] Yiq yiq_from_rgb(const RGBd& encoded) noexcept;
[[nodiscard]] RGBd rgb_from_yiq(const Yiq& yiq) noexcept;

struct YiqSystem {
    static constexpr std::string_view kName = "yiq";
    static constexpr std::string_view kHelp = "Y'IQ of NTSC, from encoded RGB";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"Y'", 0.0, 1.0, "", "luma"},
                                               ColorComponent{"I", -0.5958, 0.5958, "", "blue to orange"},
                                               ColorComponent{"Q", -0.5226, 0.5226, "", "green to purple"}};
    bool operator==(const YiqSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const YiqSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const YiqSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
