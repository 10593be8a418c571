#pragma once
// Linear RGB spaces, by the chromaticities of their primaries and white. Matrices are derived from these, so that
// RGB (1, 1, 1) is the white with Y = 1. Transfer functions are no part of this.

#include <string>
#include <string_view>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/chromaticity.h"

namespace emulsion {

/// Chromaticities are CIE 1931 x and y.
struct RgbSpace {
    std::string name;
    Chromaticity red, green, blue, white;
    bool operator==(const RgbSpace&) const = default;
};

/// A space of data/rgb_colourspaces.csv: "sRGB", "Rec709", "Rec2020", "Display_P3", ...; spelt as core/name_key.h
/// allows, so that "display-p3" will do; "ACEScg",
/// "ACES2065-1" and "ProPhoto" are short for the names with their primaries.
/// \throws std::invalid_argument for an unknown name, listing those that exist.
[[nodiscard]] const RgbSpace& rgb_space(std::string_view name);

/// Columns are the XYZ of the primaries, scaled to sum to the white with Y = 1.
/// \throws std::invalid_argument if the primaries lie on one line.
[[nodiscard]] Matrix3 xyz_from_rgb(const RgbSpace& space);
[[nodiscard]] Matrix3 rgb_from_xyz(const RgbSpace& space);

/// M_to^-1 M_from: from linear RGB of one display to that of another which shows the same XYZ. Nothing is adapted: if
/// the whites differ, RGB (1, 1, 1) doesn't become (1, 1, 1).
/// \throws std::invalid_argument as xyz_from_rgb.
[[nodiscard]] Matrix3 rgb_from_rgb(const RgbSpace& from, const RgbSpace& to);
/// M_to^-1 A M_from, with A from XYZ under the white of `from` to XYZ under that of `to`.
[[nodiscard]] Matrix3 rgb_from_rgb(const RgbSpace& from, const RgbSpace& to, const Matrix3& adaptation);

}  // namespace emulsion
