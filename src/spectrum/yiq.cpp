#include "spectrum/yiq.h"

#include <cmath>
#include <numbers>

#include "spectrum/color_context.h"
#include "spectrum/yuv.h"

namespace emulsion {

namespace {

constexpr double kTurn = kYiqTurn_deg * std::numbers::pi / 180.0;

}  // namespace

Yiq yiq_from_rgb(const RGBd& encoded) noexcept {
    const Yuv yuv = yuv_from_rgb(encoded);
    const double cosine = std::cos(kTurn), sine = std::sin(kTurn);
    return {yuv.luma, yuv.v * cosine - yuv.u * sine, yuv.v * sine + yuv.u * cosine};
}

RGBd rgb_from_yiq(const Yiq& yiq) noexcept {
    const double cosine = std::cos(kTurn), sine = std::sin(kTurn);
    return rgb_from_yuv({yiq.luma, yiq.q * cosine - yiq.i * sine, yiq.q * sine + yiq.i * cosine});
}

ColorValues from_xyz(const YiqSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Yiq yiq = yiq_from_rgb(context.encoded_from_xyz(xyz));
    return {{yiq.luma, yiq.i, yiq.q}};
}

XYZd to_xyz(const YiqSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return context.xyz_from_encoded(rgb_from_yiq({color.value[0], color.value[1], color.value[2]}));
}

}  // namespace emulsion
