#include "spectrum/hsl.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spectrum/color_context.h"
#include "spectrum/hsv.h"

namespace emulsion {

namespace {

/// The chroma of saturation 1.
double full_chroma(double lightness) noexcept { return 1.0 - std::abs(2.0 * lightness - 1.0); }

}  // namespace

Hsl hsl_from_rgb(const RGBd& encoded) noexcept {
    const auto [r, g, b] = encoded;
    if (std::isnan(r) || std::isnan(g) || std::isnan(b)) {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        return {kNan, kNan, kNan};
    }
    const double greatest = std::max({r, g, b}), least = std::min({r, g, b});
    const double lightness = 0.5 * (greatest + least), chroma = greatest - least;
    return {hexagon_hue_deg(encoded), chroma == 0.0 ? 0.0 : chroma / full_chroma(lightness), lightness};
}

RGBd rgb_from_hsl(const Hsl& hsl) noexcept {
    const double half_chroma = 0.5 * hsl.saturation * full_chroma(hsl.lightness);
    return rgb_of_hexagon_hue(hsl.hue_deg, hsl.lightness - half_chroma, hsl.lightness + half_chroma);
}

ColorValues from_xyz(const HslSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Hsl hsl = hsl_from_rgb(context.encoded_from_xyz(xyz));
    return {{hsl.hue_deg, hsl.saturation, hsl.lightness}};
}

XYZd to_xyz(const HslSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return context.xyz_from_encoded(rgb_from_hsl({color.value[0], color.value[1], color.value[2]}));
}

}  // namespace emulsion
