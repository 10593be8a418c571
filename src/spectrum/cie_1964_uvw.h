#pragma once
// The CIE 1964 uniform colour space U*V*W*. Superseded by CIELUV and CIELAB in 1976; the colour rendering index is
// still defined in it. XYZ is relative: Y = 1 for the white, which is where W* = 99.04.

#include "core/color.h"
#include "spectrum/chromaticity.h"

namespace emulsion {

/// W* is the lightness; U* > 0 is reddish, V* > 0 yellowish. The white is (0, 0, 99.04).
struct Cie1964Uvw {
    double u = 0.0, v = 0.0, w = 0.0;
    bool operator==(const Cie1964Uvw&) const = default;
};

/// W* = 25 (100 Y)^(1/3) - 17, U* = 13 W* (u - u0), V* = 13 W* (v - v0), with the CIE 1960 u, v of colour and white.
///
/// Meant for 100 Y in 1..100. Below, the formulas go on: W* reaches 0 at 100 Y = 0.314, where all chromaticities meet,
/// and -17 at Y = 0, with U* and V* of the wrong sign in between; the cube root of a negative Y is negative. Black is
/// (0, 0, -17): it is given the white's chromaticity, having none. Not finite where X + 15 Y + 3 Z = 0 otherwise.
/// Source: Wyszecki, JOSA 53 (1963); CIE 13.3-1995, section 5.
[[nodiscard]] Cie1964Uvw uvw_from_xyz(const XYZd& xyz, const XYZd& white) noexcept;

/// The same from chromaticities and Y, with Y = 1 for the white.
[[nodiscard]] Cie1964Uvw uvw_of(const Uv1960& uv, double luminance, const Uv1960& white) noexcept;

/// The inverse. U* = V* = 0 is the white's chromaticity, also at W* = 0, where all others are lost: the chromaticity
/// comes back with a relative error of some 1e-16 / |W*|. Not finite at W* = 0 with other U* and V*, nor for colours
/// without luminance except black (v = 0).
[[nodiscard]] XYZd xyz_from_uvw(const Cie1964Uvw& uvw, const XYZd& white) noexcept;

}  // namespace emulsion
