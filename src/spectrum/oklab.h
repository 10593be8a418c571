#pragma once
// Oklab. XYZ is relative, Y = 1 for the white, and for D65: colours seen under another white have to be adapted first,
// nothing here does.

#include <array>
#include <string_view>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/color_values.h"

namespace emulsion {

/// L is 1 for white; a > 0 is reddish, b > 0 yellowish.
struct Oklab {
    double l = 0.0, a = 0.0, b = 0.0;
    bool operator==(const Oklab&) const = default;
};

/// The same with a and b as chroma and hue, in degrees, in [0, 360): see spectrum/hue.h.
struct Oklch {
    double l = 0.0, chroma = 0.0, hue_deg = 0.0;
    bool operator==(const Oklch&) const = default;
};

/// M1: cone responses from XYZ, as published, to ten decimals.
inline constexpr Matrix3 kOklabConesFromXyz{{{{0.8189330101, 0.3618667424, -0.1288597137},
                                              {0.0329845436, 0.9293118715, 0.0361456387},
                                              {0.0482003018, 0.2643662691, 0.6338517070}}}};
/// M2: Lab from the cube roots of cone responses, as published, to ten decimals.
inline constexpr Matrix3 kOklabFromRoots{{{{0.2104542553, 0.7936177850, -0.0040720468},
                                           {1.9779984951, -2.4285922050, 0.4505937099},
                                           {0.0259040371, 0.7827717662, -0.8086757660}}}};

/// M2 cbrt(M1 XYZ), with the cube root of negative numbers negative, so that every XYZ has an Oklab.
/// The matrices were made for a D65 that is not quite (0.3127, 0.3290): that white comes out with |a| and |b| of some
/// 1e-4, not 0. CSS Color 4 has other digits, with which it is 0; these are the author's.
/// Source: Ottosson, "A perceptual color space for image processing" (2020), https://bottosson.github.io/posts/oklab.
[[nodiscard]] Oklab oklab_from_xyz(const XYZd& xyz) noexcept;

/// By the numerical inverses of both matrices in double precision, not by the rounded inverses in print, so that it
/// undoes oklab_from_xyz to some 1e-15.
[[nodiscard]] XYZd xyz_from_oklab(const Oklab& oklab) noexcept;

[[nodiscard]] Oklch oklch_from_oklab(const Oklab& oklab) noexcept;
[[nodiscard]] Oklab oklab_from_oklch(const Oklch& oklch) noexcept;

struct OklabSystem {
    static constexpr std::string_view kName = "oklab";
    static constexpr std::string_view kHelp = "Oklab, of XYZ for D65";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L", 0.0, 1.0, "", "lightness"},
                                               ColorComponent{"a", -0.234, 0.2763, "", "green to red"},
                                               ColorComponent{"b", -0.3117, 0.1985, "", "blue to yellow"}};
    bool operator==(const OklabSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const OklabSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const OklabSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

struct OklchSystem {
    static constexpr std::string_view kName = "oklch";
    static constexpr std::string_view kHelp = "Oklab with chroma and hue, of XYZ for D65";
    static constexpr std::string_view kDomain = "every XYZ";
    static constexpr std::array kComponents = {ColorComponent{"L", 0.0, 1.0, "", "lightness"},
                                               ColorComponent{"C", 0.0, 0.3226, "", "chroma"},
                                               ColorComponent{"h", 0.0, 360.0, "deg", "hue"}};
    bool operator==(const OklchSystem&) const = default;
};
[[nodiscard]] ColorValues from_xyz(const OklchSystem& system, const XYZd& xyz, const ColorContext& context) noexcept;
[[nodiscard]] XYZd to_xyz(const OklchSystem& system, const ColorValues& color, const ColorContext& context) noexcept;

}  // namespace emulsion
