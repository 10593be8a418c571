#include "spectrum/xyy.h"

#include "spectrum/chromaticity.h"
#include "spectrum/color_context.h"

namespace emulsion {

Xyy xyy_from_xyz(const XYZd& xyz, const XYZd& white) noexcept {
    const auto [x, y] = chromaticity_of(xyz == XYZd{} ? white : xyz);
    return {x, y, xyz.y};
}

XYZd xyz_from_xyy(const Xyy& xyy) noexcept {
    const double sum = xyy.luminance / xyy.y;
    return {xyy.x * sum, xyy.luminance, (1.0 - xyy.x - xyy.y) * sum};
}

ColorValues from_xyz(const XyySystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Xyy xyy = xyy_from_xyz(xyz, context.white());
    return {{xyy.x, xyy.y, xyy.luminance}};
}

XYZd to_xyz(const XyySystem& /*system*/, const ColorValues& color, const ColorContext& /*context*/) noexcept {
    return xyz_from_xyy({color.value[0], color.value[1], color.value[2]});
}

}  // namespace emulsion
