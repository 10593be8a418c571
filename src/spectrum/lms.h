#pragma once
// LMS: responses of the long-, medium- and short-wavelength cones of the eye, linear in XYZ. XYZ may be absolute or
// relative; LMS is in the same unit. The matrices for CIE 1931 XYZ are fits, made for chromatic adaptation
// (spectrum/chromatic_adaptation.h); two of them are "sharpened": narrower than the cones, with negative responses for
// saturated colours.

#include <array>
#include <concepts>
#include <string_view>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/chromatic_adaptation.h"
#include "spectrum/color_values.h"
#include "spectrum/cone_fundamentals.h"

namespace emulsion {

struct Lms {
    double l = 0.0, m = 0.0, s = 0.0;
    bool operator==(const Lms&) const = default;
};

/// Hunt, Pointer and Estevez, as fundamentals for which the equal-energy white has L = M = S (not the matrix that is
/// normalised to D65, which adaptation uses). Source: Hunt, The Reproduction of Colour, 6th ed. (2004); CIE 159:2004.
inline constexpr Matrix3 kLmsHpeFromXyz{
    {{{0.38971, 0.68898, -0.07868}, {-0.22981, 1.18340, 0.04641}, {0.0, 0.0, 1.0}}}};

/// \param lms_from_xyz the matrix of one of the systems below
[[nodiscard]] Lms lms_of(const Matrix3& lms_from_xyz, const XYZd& xyz) noexcept;
/// \param xyz_from_lms the inverse of such a matrix
[[nodiscard]] XYZd xyz_of(const Matrix3& xyz_from_lms, const Lms& lms) noexcept;

struct LmsHpeSystem {
    static constexpr std::string_view kName = "lms-hpe";
    static constexpr std::string_view kHelp = "cones by Hunt, Pointer and Estevez";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L", 0.0, 0.9738, "", "long-wavelength cones"},
                                               ColorComponent{"M", 0.0, 1.016, "", "medium-wavelength cones"},
                                               ColorComponent{"S", 0.0, 1.09, "", "short-wavelength cones"}};
    [[nodiscard]] static Matrix3 lms_from_xyz() noexcept { return kLmsHpeFromXyz; }
    bool operator==(const LmsHpeSystem&) const = default;
};

struct LmsBradfordSystem {
    static constexpr std::string_view kName = "lms-bradford";
    static constexpr std::string_view kHelp = "sharpened cones of the Bradford adaptation";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L", 0.0, 0.9415, "", "long-wavelength cones"},
                                               ColorComponent{"M", 0.0, 1.041, "", "medium-wavelength cones"},
                                               ColorComponent{"S", 0.0, 1.09, "", "short-wavelength cones"}};
    [[nodiscard]] static Matrix3 lms_from_xyz() noexcept { return cone_from_xyz(BradfordAdaptation{}); }
    bool operator==(const LmsBradfordSystem&) const = default;
};

struct LmsCat02System {
    static constexpr std::string_view kName = "lms-cat02";
    static constexpr std::string_view kHelp = "sharpened cones of CAT02 and CIECAM02";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L", 0.0, 0.9493, "", "long-wavelength cones"},
                                               ColorComponent{"M", 0.0, 1.036, "", "medium-wavelength cones"},
                                               ColorComponent{"S", 0.0, 1.088, "", "short-wavelength cones"}};
    [[nodiscard]] static Matrix3 lms_from_xyz() noexcept { return cone_from_xyz(Cat02Adaptation{}); }
    bool operator==(const LmsCat02System&) const = default;
};

struct LmsCat16System {
    static constexpr std::string_view kName = "lms-cat16";
    static constexpr std::string_view kHelp = "cones of CAT16 and CAM16";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L", 0.0, 0.9756, "", "long-wavelength cones"},
                                               ColorComponent{"M", 0.0, 1.017, "", "medium-wavelength cones"},
                                               ColorComponent{"S", 0.0, 1.085, "", "short-wavelength cones"}};
    [[nodiscard]] static Matrix3 lms_from_xyz() noexcept { return cone_from_xyz(Cat16Adaptation{}); }
    bool operator==(const LmsCat16System&) const = default;
};

/// The cones themselves, each with its peak scaled to 1: XYZ has to be that of the CIE 2015 2 degree observer
/// (spectrum/observer.h). Of CIE 1931 XYZ, which no linear map takes to cones, the numbers mean little.
/// Source: Stockman & Sharpe, Vision Research 40 (2000); CIE 170-2:2015. See spectrum/cone_fundamentals.h.
struct LmsCie2015System {
    static constexpr std::string_view kName = "lms-cie2015";
    static constexpr std::string_view kHelp = "cones of Stockman and Sharpe, of CIE 2015 2 degree XYZ (not 1931)";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L", 0.0, 1.013, "", "long-wavelength cones"},
                                               ColorComponent{"M", 0.0, 0.8665, "", "medium-wavelength cones"},
                                               ColorComponent{"S", 0.0, 0.5629, "", "short-wavelength cones"}};
    [[nodiscard]] static Matrix3 lms_from_xyz() { return inverse(xyz_2015_from_stockman_sharpe()); }
    bool operator==(const LmsCie2015System&) const = default;
};

template <class T>
concept LmsSystem = requires {
    { T::lms_from_xyz() } -> std::same_as<Matrix3>;
};

template <LmsSystem System>
[[nodiscard]] ColorValues from_xyz(const System& /*system*/, const XYZd& xyz,
                                   const ColorContext& /*context*/) noexcept {
    static const Matrix3 lms_from_xyz = System::lms_from_xyz();
    const Lms lms = lms_of(lms_from_xyz, xyz);
    return {{lms.l, lms.m, lms.s}};
}
template <LmsSystem System>
[[nodiscard]] XYZd to_xyz(const System& /*system*/, const ColorValues& color,
                          const ColorContext& /*context*/) noexcept {
    static const Matrix3 xyz_from_lms = inverse(System::lms_from_xyz());
    return xyz_of(xyz_from_lms, Lms{color.value[0], color.value[1], color.value[2]});
}

}  // namespace emulsion
