#pragma once
// Chromaticity: the colour of a light without its amount. XYZ may be absolute or relative, and of any observer; x, y
// and the two u, v systems are projective maps of one another, so that straight lines stay straight.
//
// Imaginary colours (outside the spectral locus, negative XYZ) have a chromaticity like any other. Where X + Y + Z = 0
// there is none: x and y are not finite, NaN for black.

#include "core/color.h"

namespace emulsion {

/// x = X / (X + Y + Z), y = Y / (X + Y + Z). Real colours: x, y > 0 and x + y < 1.
struct Chromaticity {
    double x = 0.0, y = 0.0;
    bool operator==(const Chromaticity&) const = default;
};

/// u', v' of the CIE 1976 uniform chromaticity scale, the one of CIELUV.
struct Uv1976 {
    double u = 0.0, v = 0.0;
    bool operator==(const Uv1976&) const = default;
};

/// u, v of the CIE 1960 uniform chromaticity scale: u = u', v = 2/3 v'. Superseded, but what correlated colour
/// temperature, U*V*W* and the colour rendering index are defined in.
struct Uv1960 {
    double u = 0.0, v = 0.0;
    bool operator==(const Uv1960&) const = default;
};

/// Not finite where X + Y + Z = 0; (NaN, NaN) for black.
[[nodiscard]] Chromaticity chromaticity_of(const XYZd& xyz) noexcept;

/// XYZ of a chromaticity and a luminance Y (of any unit), which may be 0 or negative.
/// \throws std::invalid_argument if y is 0 (no amount of such a light has luminance) or a number is not finite.
[[nodiscard]] XYZd xyz_of(const Chromaticity& chromaticity, double luminance = 1.0);

/// u' = 4x / (-2x + 12y + 3), v' = 9y / (-2x + 12y + 3). Not finite where the denominator is 0: on a line outside the
/// locus. Source: CIE 15:2004, section 8.1.
[[nodiscard]] Uv1976 uv_1976_of(const Chromaticity& chromaticity) noexcept;
/// The inverse: x = 9u' / (6u' - 16v' + 12), y = 4v' / (6u' - 16v' + 12).
[[nodiscard]] Chromaticity chromaticity_of(const Uv1976& uv) noexcept;

/// u = 4x / (-2x + 12y + 3), v = 6y / (-2x + 12y + 3). Source: CIE 15:2004, section 8.1, note.
[[nodiscard]] Uv1960 uv_1960_of(const Chromaticity& chromaticity) noexcept;
/// The inverse: x = 3u / (2u - 8v + 4), y = 2v / (2u - 8v + 4).
[[nodiscard]] Chromaticity chromaticity_of(const Uv1960& uv) noexcept;

/// u' = 4X / (X + 15Y + 3Z), v' = 9Y / (X + 15Y + 3Z); (NaN, NaN) for black.
[[nodiscard]] Uv1976 uv_1976_of(const XYZd& xyz) noexcept;
/// u = 4X / (X + 15Y + 3Z), v = 6Y / (X + 15Y + 3Z); (NaN, NaN) for black.
[[nodiscard]] Uv1960 uv_1960_of(const XYZd& xyz) noexcept;

}  // namespace emulsion
