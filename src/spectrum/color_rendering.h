#pragma once
// The CIE colour rendering index: how much like under a blackbody or daylight of the same colour temperature fourteen
// test colours look under a light.

#include <array>
#include <cstddef>

#include "spectrum/spectrum.h"

namespace emulsion {

inline constexpr std::size_t kTestColorCount = 14;

/// Above this distance between light and reference, in CIE 1960 u, v, the index is inaccurate.
/// Source: CIE 13.3-1995, section 5, on the tolerance for the reference illuminant.
inline constexpr double kLargestReferenceDistance = 5.4e-3;

struct ColorRendering {
    double general_index = 0.0;                           ///< Ra: the mean of R1 to R8; at most 100
    std::array<double, kTestColorCount> special_index{};  ///< R1 to R14; at most 100, and may be negative
    double reference_K = 0.0;                             ///< correlated colour temperature of light and reference
    double reference_distance = 0.0;                      ///< in CIE 1960 u, v; see kLargestReferenceDistance
};

struct ColorRenderingMethod {
    enum class Integration {
        exact,      ///< integrals over 360-830 nm, like all of this library
        every_5nm,  ///< sums at 380, 385, ... 780 nm, by which published figures are made; refuses lines without width
    };
    Integration integration = Integration::exact;
    /// From here up the reference is daylight, below a blackbody; [4000, 25000]. 5000 K by the standard. The figures of
    /// CIE 15:2004, table T.8 (FL3.1 to FL3.15) are made with daylight from 4000 K up.
    double daylight_from_K = 5000.0;
};

/// R_i = 100 - 4.6 times the difference in U*V*W* of test colour i under light and reference, after von Kries's
/// adaptation to the reference's white; Ra is the mean of the first eight.
///
/// The reference has exactly the light's colour temperature, and daylight the exact weights of its components, not
/// those rounded to three decimals. So D65 itself has an Ra of 99.998; blackbodies have 100.
///
/// Source: CIE 13.3-1995, section 5, with its test colours at every 5 nm.
/// \throws std::invalid_argument as xyz_of_reflectance or xyz_by_summation does, for a light that has no correlated
/// colour temperature in [500, 25000] K, and for a method out of range.
[[nodiscard]] ColorRendering color_rendering(const Spectrum& light, const ColorRenderingMethod& method = {});

}  // namespace emulsion
