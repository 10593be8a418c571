#include "spectrum/cmyk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spectrum/color_context.h"

namespace emulsion {

Cmyk cmyk_from_rgb(const RGBd& encoded) noexcept {
    const auto [r, g, b] = encoded;
    if (std::isnan(r) || std::isnan(g) || std::isnan(b)) {
        constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
        return {kNan, kNan, kNan, kNan};
    }
    const double greatest = std::max({r, g, b});
    // (C - K) / (1 - K), with the 1 taken out of both.
    const auto ink = [greatest](double component) {
        return component == greatest ? 0.0 : (greatest - component) / greatest;
    };
    return {ink(r), ink(g), ink(b), 1.0 - greatest};
}

RGBd rgb_from_cmyk(const Cmyk& cmyk) noexcept {
    const double greatest = 1.0 - cmyk.k;
    return {(1.0 - cmyk.c) * greatest, (1.0 - cmyk.m) * greatest, (1.0 - cmyk.y) * greatest};
}

ColorValues from_xyz(const CmykSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Cmyk cmyk = cmyk_from_rgb(context.encoded_from_xyz(xyz));
    return {{cmyk.c, cmyk.m, cmyk.y, cmyk.k}, 4};
}

XYZd to_xyz(const CmykSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return context.xyz_from_encoded(rgb_from_cmyk({color.value[0], color.value[1], color.value[2], color.value[3]}));
}

}  // namespace emulsion
