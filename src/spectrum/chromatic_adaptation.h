#pragma once
// Chromatic adaptation: what XYZ looks under one white as a given XYZ does under another. All methods here are of von
// Kries's form: three cone-like responses are scaled, each by itself, so that one white becomes the other. They differ
// in what they take for the responses.
//
// XYZ and whites are relative or absolute, but all the same; usually Y = 1 for both whites.

#include <string_view>
#include <variant>

#include "core/color.h"
#include "core/matrix3.h"
#include "core/named_value.h"

namespace emulsion {

/// The responses of Lam 1985, "sharper" than cones: what ICC profiles use. Without the power on the blue response that
/// the full transform has: that makes it no matrix, and the ICC, too, leaves it out.
/// Source: ICC.1, annex E.
struct BradfordAdaptation {
    static constexpr std::string_view kName = "bradford";
    static constexpr std::string_view kHelp = "linear Bradford, as in ICC profiles";
    bool operator==(const BradfordAdaptation&) const = default;
};

/// X, Y and Z themselves, as CIELAB does it.
struct XyzScalingAdaptation {
    static constexpr std::string_view kName = "xyz-scaling";
    static constexpr std::string_view kHelp = "X, Y and Z each by itself, as in CIELAB";
    bool operator==(const XyzScalingAdaptation&) const = default;
};

/// Hunt-Pointer-Estevez cones, in the scale in which D65 has equal responses. Rows of another scale (equal for
/// illuminant E) give the same adaptation but for their rounding, 1e-4.
/// Source: Hunt, "The Reproduction of Colour", 6th ed., 2004; Fairchild, "Color Appearance Models", 2nd ed., 2005.
struct VonKriesAdaptation {
    static constexpr std::string_view kName = "von-kries";
    static constexpr std::string_view kHelp = "Hunt-Pointer-Estevez cones";
    bool operator==(const VonKriesAdaptation&) const = default;
};

/// Source: CIE 159:2004 (CIECAM02).
struct Cat02Adaptation {
    static constexpr std::string_view kName = "cat02";
    static constexpr std::string_view kHelp = "that of CIECAM02";
    bool operator==(const Cat02Adaptation&) const = default;
};

/// Source: Li et al., "Comprehensive color solutions: CAM16, CAT16, and CAM16-UCS", Color Res. Appl. 42(6), 2017;
/// CIE 248:2022.
struct Cat16Adaptation {
    static constexpr std::string_view kName = "cat16";
    static constexpr std::string_view kHelp = "that of CIECAM16";
    bool operator==(const Cat16Adaptation&) const = default;
};

/// All methods; the first is the default.
using ChromaticAdaptation =
    std::variant<BradfordAdaptation, XyzScalingAdaptation, VonKriesAdaptation, Cat02Adaptation, Cat16Adaptation>;

/// Responses from XYZ.
[[nodiscard]] Matrix3 cone_from_xyz(const ChromaticAdaptation& method) noexcept;

/// M^-1 diag(degree to_i / from_i + 1 - degree) M, for XYZ seen under `from_white` to XYZ under `to_white`.
/// Exactly the identity if the whites agree or degree is 0; maps white to white at degree 1, where swapping the whites
/// gives the inverse. Between, neither holds. To illuminant E it is the incomplete adaptation of CIECAM02 and CIECAM16.
/// Colours that only one white can make (saturated blues from A to D65) may come out with negative values.
/// \param degree of adaptation, in [0, 1]: 0 none, 1 complete
/// \throws std::invalid_argument for a degree out of its range, and for a white with a response that is not positive
/// and finite, naming method, white and responses.
[[nodiscard]] Matrix3 adaptation_matrix(const ChromaticAdaptation& method, const XYZd& from_white, const XYZd& to_white,
                                        double degree = 1.0);

}  // namespace emulsion
