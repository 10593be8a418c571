#pragma once
// ICtCp of high dynamic range television, in its PQ form: of light as shown, absolute. XYZ here is absolute too, CIE
// 1931, in cd/m^2. A picture whose white has Y = 1 is given a luminance of its white first: ITU-R BT.2408 has 203
// cd/m^2 (kIctcpReferenceWhite_cdm2).

#include "core/color.h"

namespace emulsion {

/// Luminance of a diffuse white, cd/m^2. Source: ITU-R BT.2408.
inline constexpr double kIctcpReferenceWhite_cdm2 = 203.0;

/// Intensity, 0 to 1 for 0 to 10000 cd/m^2 by PQ; Ct > 0 is bluish, < 0 yellowish, Cp > 0 reddish, < 0 greenish. Ct and
/// Cp lie in [-0.5, 0.5] for colours of BT.2020; greys of D65's chromaticity have Ct = Cp = 0.
struct ICtCp {
    double i = 0.0, ct = 0.0, cp = 0.0;
    bool operator==(const ICtCp&) const = default;
};

/// XYZ to linear RGB of BT.2020 over 10000 cd/m^2, to LMS = (1688 R + 2146 G + 262 B, 683 R + 2951 G + 462 B,
/// 99 R + 309 G + 3688 B) / 4096, each encoded by PQ (spectrum/pq.h) to L'M'S', to
/// I = (L' + M') / 2, Ct = (6610 L' - 13613 M' + 7003 S') / 4096, Cp = (17933 L' - 17390 M' - 543 S') / 4096.
/// Source: ITU-R BT.2100-2, table 7. RGB from XYZ by the primaries and white of BT.2020, derived.
/// Black is (7.3e-7, 0, 0), as PQ has it. Negative LMS, of colours far outside BT.2020, are encoded as -PQ(-x): ours,
/// the standard has none; light above 10000 cd/m^2 goes on.
[[nodiscard]] ICtCp ictcp_from_xyz(const XYZd& xyz_cdm2);

/// The inverse, but for black colours: L'M'S' closer to 0 than 7.3e-7 are 0.
[[nodiscard]] XYZd xyz_from_ictcp(const ICtCp& ictcp);

}  // namespace emulsion
