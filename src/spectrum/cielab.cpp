#include "spectrum/cielab.h"

#include <cmath>

#include "spectrum/color_context.h"
#include "spectrum/hue.h"
#include "spectrum/lab_function.h"

namespace emulsion {

namespace {

double lab_f_inverse(double f) noexcept {
    if (f > kLabKnee) return f * f * f;
    return (f - kLabToeOffset) / kLabToeSlope;
}

}  // namespace

double cie_lightness(double relative_luminance) noexcept {
    // Below the knee without the 16 that would cancel: exactly 0 for black.
    if (relative_luminance > kLabKnee * kLabKnee * kLabKnee) return 116.0 * std::cbrt(relative_luminance) - 16.0;
    return 116.0 * kLabToeSlope * relative_luminance;
}

double relative_luminance_of(double lightness) noexcept {
    const double f = (lightness + 16.0) / 116.0;
    if (f > kLabKnee) return f * f * f;
    return lightness / (116.0 * kLabToeSlope);
}

Lab lab_from_xyz(const XYZd& xyz, const XYZd& white) noexcept {
    const double fx = lab_f(xyz.x / white.x), fy = lab_f(xyz.y / white.y), fz = lab_f(xyz.z / white.z);
    return {cie_lightness(xyz.y / white.y), 500.0 * (fx - fy), 200.0 * (fy - fz)};
}

XYZd xyz_from_lab(const Lab& lab, const XYZd& white) noexcept {
    const double fy = (lab.l + 16.0) / 116.0;
    const double fx = fy + lab.a / 500.0, fz = fy - lab.b / 200.0;
    return {white.x * lab_f_inverse(fx), white.y * relative_luminance_of(lab.l), white.z * lab_f_inverse(fz)};
}

LchAb lch_from_lab(const Lab& lab) noexcept {
    const auto [chroma, hue_deg] = chroma_hue_of({lab.a, lab.b});
    return {lab.l, chroma, hue_deg};
}

Lab lab_from_lch(const LchAb& lch) noexcept {
    const auto [a, b] = chromatic_of({lch.chroma, lch.hue_deg});
    return {lch.l, a, b};
}

ColorValues from_xyz(const LabSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const Lab lab = lab_from_xyz(xyz, context.white());
    return {{lab.l, lab.a, lab.b}};
}

XYZd to_xyz(const LabSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return xyz_from_lab({color.value[0], color.value[1], color.value[2]}, context.white());
}

ColorValues from_xyz(const LchAbSystem& /*system*/, const XYZd& xyz, const ColorContext& context) noexcept {
    const LchAb lch = lch_from_lab(lab_from_xyz(xyz, context.white()));
    return {{lch.l, lch.chroma, lch.hue_deg}};
}

XYZd to_xyz(const LchAbSystem& /*system*/, const ColorValues& color, const ColorContext& context) noexcept {
    return xyz_from_lab(lab_from_lch({color.value[0], color.value[1], color.value[2]}), context.white());
}

}  // namespace emulsion
