#include "spectrum/cieluv.h"

#include "spectrum/chromaticity.h"
#include "spectrum/cielab.h"
#include "spectrum/color_context.h"
#include "spectrum/hue.h"

namespace emulsion {

Luv luv_from_xyz(const XYZd& xyz, const XYZd& white) noexcept {
    if (xyz == XYZd{}) return {};
    const double l = cie_lightness(xyz.y / white.y);
    const auto [u, v] = uv_1976_of(xyz);
    const auto [u_white, v_white] = uv_1976_of(white);
    return {l, 13.0 * l * (u - u_white), 13.0 * l * (v - v_white)};
}

XYZd xyz_from_luv(const Luv& luv, const XYZd& white) noexcept {
    if (luv == Luv{}) return {};
    const auto [u_white, v_white] = uv_1976_of(white);
    const double u = luv.u / (13.0 * luv.l) + u_white, v = luv.v / (13.0 * luv.l) + v_white;
    const double y = white.y * relative_luminance_of(luv.l);
    return {2.25 * y * u / v, y, y * (3.0 - 0.75 * u - 5.0 * v) / v};
}

LchUv lch_from_luv(const Luv& luv) noexcept {
    const auto [chroma, hue_deg] = chroma_hue_of({luv.u, luv.v});
    return {luv.l, chroma, hue_deg};
}

Luv luv_from_lch(const LchUv& lch) noexcept {
    const auto [u, v] = chromatic_of({lch.chroma, lch.hue_deg});
    return {lch.l, u, v};
}

ColorValues from_xyz(const LuvSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Luv luv = luv_from_xyz(xyz, context.white());
    return {{luv.l, luv.u, luv.v}};
}

XYZd to_xyz(const LuvSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return xyz_from_luv({color.value[0], color.value[1], color.value[2]}, context.white());
}

ColorValues from_xyz(const LchUvSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const LchUv lch = lch_from_luv(luv_from_xyz(xyz, context.white()));
    return {{lch.l, lch.chroma, lch.hue_deg}};
}

XYZd to_xyz(const LchUvSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return xyz_from_luv(luv_from_lch({color.value[0], color.value[1], color.value[2]}), context.white());
}

}  // namespace emulsion
