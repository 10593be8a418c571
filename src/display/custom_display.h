#pragma once
// A display as it was measured.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "display/display_light.h"
#include "spectrum/rgb_space.h"
#include "spectrum/srgb_transfer.h"

namespace emulsion {

/// CIE 1931 x, y of the primaries and of the white; by default those of sRGB. Its own transfer function is that of
/// sRGB, too: another one, or a measured table, is given as such.
struct CustomDisplay {
    static constexpr std::string_view kName = "custom";
    static constexpr std::string_view kHelp = "primaries and white as measured";
    static constexpr SrgbTransfer kTransfer = {};
    double rx = 0.64, ry = 0.33;
    double gx = 0.3, gy = 0.6;
    double bx = 0.15, by = 0.06;
    double wx = 0.3127, wy = 0.329;
    double peak_cdm2 = 80.0;
    double black_cdm2 = 0.0;
    double flare_cdm2 = 0.0;
    bool operator==(const CustomDisplay&) const = default;

    static constexpr ParameterRange kChromaticity = {0.0, 1.0};
    static constexpr std::array kParameters = {
        Parameter<CustomDisplay>{"rx", &CustomDisplay::rx, kChromaticity, "", "x of red"},
        Parameter<CustomDisplay>{"ry", &CustomDisplay::ry, kChromaticity, "", "y of red"},
        Parameter<CustomDisplay>{"gx", &CustomDisplay::gx, kChromaticity, "", "x of green"},
        Parameter<CustomDisplay>{"gy", &CustomDisplay::gy, kChromaticity, "", "y of green"},
        Parameter<CustomDisplay>{"bx", &CustomDisplay::bx, kChromaticity, "", "x of blue"},
        Parameter<CustomDisplay>{"by", &CustomDisplay::by, kChromaticity, "", "y of blue"},
        Parameter<CustomDisplay>{"wx", &CustomDisplay::wx, kChromaticity, "", "x of white"},
        Parameter<CustomDisplay>{"wy", &CustomDisplay::wy, kChromaticity, "", "y of white"},
        peak_parameter<CustomDisplay>(),
        black_parameter<CustomDisplay>(),
        flare_parameter<CustomDisplay>()};
};

/// How far inside the triangle of the primaries the white must lie: with less, some primary has next to no part in it.
inline constexpr double kLeastWhiteDistance = 0.001;

[[nodiscard]] RgbSpace rgb_space(const CustomDisplay& display);

/// \throws std::invalid_argument naming the display and the chromaticities if the primaries lie on one line, or the
/// white isn't kLeastWhiteDistance inside their triangle.
void check_triangle(const CustomDisplay& display);

/// That each of Oklab's cones responds to the white, as it does to every light: few whites inside a triangle are none.
/// \throws std::invalid_argument naming the display, wx and wy if one doesn't.
void check_white(const CustomDisplay& display);

}  // namespace emulsion
