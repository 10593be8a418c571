#include "spectrum/hsv.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "spectrum/color_context.h"

namespace emulsion {

double hexagon_hue_deg(const RGBd& rgb) noexcept {
    const auto [r, g, b] = rgb;
    const double greatest = std::max({r, g, b}), chroma = greatest - std::min({r, g, b});
    if (chroma == 0.0) return 0.0;
    double sector = 0.0;
    if (greatest == r) {
        sector = (g - b) / chroma;
    } else if (greatest == g) {
        sector = 2.0 + (b - r) / chroma;
    } else {
        sector = 4.0 + (r - g) / chroma;
    }
    const double hue_deg = 60.0 * (sector < 0.0 ? sector + 6.0 : sector);
    return hue_deg < 360.0 ? hue_deg : 0.0;  // 360 where the sum was rounded up
}

RGBd rgb_of_hexagon_hue(double hue_deg, double least, double greatest) noexcept {
    const double turns = hue_deg / 360.0;
    const double sector = 6.0 * (turns - std::floor(turns));
    // Each component is a trapezoid over the hue: `least` for two sectors, a slope, `greatest` for two, a slope.
    const auto at = [&](double peak) {
        const double distance = std::abs(sector - peak);
        const double share = std::clamp(2.0 - std::min(distance, 6.0 - distance), 0.0, 1.0);
        return least + share * (greatest - least);
    };
    return {at(0.0), at(2.0), at(4.0)};
}

Hsv hsv_from_rgb(const RGBd& encoded) noexcept {
    const auto [r, g, b] = encoded;
    if (std::isnan(r) || std::isnan(g) || std::isnan(b)) {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        return {kNan, kNan, kNan};
    }
    const double value = std::max({r, g, b}), chroma = value - std::min({r, g, b});
    return {hexagon_hue_deg(encoded), chroma == 0.0 ? 0.0 : chroma / value, value};
}

RGBd rgb_from_hsv(const Hsv& hsv) noexcept {
    return rgb_of_hexagon_hue(hsv.hue_deg, hsv.value * (1.0 - hsv.saturation), hsv.value);
}

ColorValues from_xyz(const HsvSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Hsv hsv = hsv_from_rgb(context.encoded_from_xyz(xyz));
    return {{hsv.hue_deg, hsv.saturation, hsv.value}};
}

XYZd to_xyz(const HsvSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return context.xyz_from_encoded(rgb_from_hsv({color.value[0], color.value[1], color.value[2]}));
}

}  // namespace emulsion
