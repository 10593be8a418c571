#include "spectrum/yuv.h"

#include "spectrum/color_context.h"
#include "spectrum/luma.h"

namespace emulsion {

Yuv yuv_from_rgb(const RGBd& encoded) noexcept {
    const LumaDifferences of = luma_differences_of(kBt601Luma, encoded);
    return {of.luma, kYuvScaleOfU * of.blue_minus, kYuvScaleOfV * of.red_minus};
}

RGBd rgb_from_yuv(const Yuv& yuv) noexcept {
    return rgb_of(kBt601Luma, {yuv.luma, yuv.u / kYuvScaleOfU, yuv.v / kYuvScaleOfV});
}

ColorValues from_xyz(const YuvSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Yuv yuv = yuv_from_rgb(context.encoded_from_xyz(xyz));
    return {{yuv.luma, yuv.u, yuv.v}};
}

XYZd to_xyz(const YuvSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return context.xyz_from_encoded(rgb_from_yuv({color.value[0], color.value[1], color.value[2]}));
}

}  // namespace emulsion
