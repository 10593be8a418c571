#include "spectrum/cielab.h"

#include <cmath>

#include "spectrum/color_context.h"
#include "spectrum/hue.h"

namespace emulsion {

namespace {

constexpr double kKnee = 6.0 / 29.0;                       // of f; that of its argument is the cube
constexpr double kToeSlope = 1.0 / (3.0 * kKnee * kKnee);  // of the cube root at the knee
constexpr double kToeOffset = 4.0 / 29.0;

double lab_f(double ratio) noexcept {
    if (ratio > kKnee * kKnee * kKnee) return std::cbrt(ratio);
    return kToeSlope * ratio + kToeOffset;
}

double lab_f_inverse(double f) noexcept {
    if (f > kKnee) return f * f * f;
    return (f - kToeOffset) / kToeSlope;
}

}  // namespace

double cie_lightness(double relative_luminance) noexcept {
    // Below the knee without the 16 that would cancel: exactly 0 for black.
    if (relative_luminance > kKnee * kKnee * kKnee) return 116.0 * std::cbrt(relative_luminance) - 16.0;
    return 116.0 * kToeSlope * relative_luminance;
}

double relative_luminance_of(double lightness) noexcept {
    const double f = (lightness + 16.0) / 116.0;
    if (f > kKnee) return f * f * f;
    return lightness / (116.0 * kToeSlope);
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
