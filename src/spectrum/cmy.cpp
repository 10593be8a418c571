#include "spectrum/cmy.h"

#include "spectrum/color_context.h"

namespace emulsion {

Cmy cmy_from_rgb(const RGBd& encoded) noexcept { return {1.0 - encoded.r, 1.0 - encoded.g, 1.0 - encoded.b}; }

RGBd rgb_from_cmy(const Cmy& cmy) noexcept { return {1.0 - cmy.c, 1.0 - cmy.m, 1.0 - cmy.y}; }

ColorValues from_xyz(const CmySystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Cmy cmy = cmy_from_rgb(context.encoded_from_xyz(xyz));
    return {{cmy.c, cmy.m, cmy.y}};
}

XYZd to_xyz(const CmySystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return context.xyz_from_encoded(rgb_from_cmy({color.value[0], color.value[1], color.value[2]}));
}

}  // namespace emulsion
