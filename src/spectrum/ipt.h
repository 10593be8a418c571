#pragma once
// IPT, a space of even hues. XYZ is relative, Y = 1 for the white, and for D65: colours seen under another white have
// to be adapted first, nothing here does.

#include <array>
#include <string_view>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// I is 1 for white; P > 0 is reddish, T > 0 yellowish.
struct Ipt {
    double i = 0.0, p = 0.0, t = 0.0;
    bool operator==(const Ipt&) const = default;
};

/// Hunt, Pointer and Estevez's cones, normalised to D65 and rounded as IPT has them (they differ in the fourth digit
/// from the usual D65 matrix, and much from the equal-energy one of spectrum/lms.h).
inline constexpr Matrix3 kIptConesFromXyz{{{{0.4002, 0.7075, -0.0807}, {-0.2280, 1.1500, 0.0612}, {0.0, 0.0, 0.9184}}}};
inline constexpr Matrix3 kIptFromPowers{
    {{{0.4000, 0.4000, 0.2000}, {4.4550, -4.8510, 0.3960}, {0.8056, 0.3572, -1.1628}}}};
inline constexpr double kIptExponent = 0.43;

/// kIptFromPowers (kIptConesFromXyz XYZ)^0.43, with the power of negative numbers negative: (-x)^p = -(x^p). Every XYZ
/// has an IPT. D65 comes out with P and T of some 1e-4, by the rounding of the matrices.
/// Source: Ebner & Fairchild, "Development and testing of a color space (IPT) with improved hue uniformity", CIC 6
/// (1998).
[[nodiscard]] Ipt ipt_from_xyz(const XYZd& xyz) noexcept;
/// The inverse, with numerically inverted matrices.
[[nodiscard]] XYZd xyz_from_ipt(const Ipt& ipt) noexcept;

struct IptSystem {
    static constexpr std::string_view kName = "ipt";
    static constexpr std::string_view kHelp = "IPT of Ebner and Fairchild, of XYZ for D65";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"I", 0.0, 1.001, "", "intensity"},
                                               ColorComponent{"P", -0.4534, 0.6624, "", "green to red"},
                                               ColorComponent{"T", -0.7486, 0.6515, "", "blue to yellow"}};
    bool operator==(const IptSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const IptSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const IptSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
