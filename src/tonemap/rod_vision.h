#pragma once
// Seeing by rods: at night colours fade, red things turn dark, and what is left looks bluish. Luminances in cd/m^2.

#include "core/color.h"
#include "core/image.h"

namespace emulsion {

/// Only rods see below the one, only cones above the other. Source: Ward Larson, Rushmeier & Piatko, "A Visibility
/// Matching Tone Reproduction Operator for High Dynamic Range Scenes", IEEE Transactions on Visualization and Computer
/// Graphics 3(4), 1997, section on colour sensitivity.
inline constexpr double kLeastMesopic_cdm2 = 0.0056, kMostMesopic_cdm2 = 5.6;

/// V = Y (1.33 (1 + (Y + Z) / X) - 1.68), in scotopic cd/m^2: a fit to the colours of a chart. Source: as above,
/// eq. 13. Departs from it past such colours: V / Y is held in [0, 10], and is 10 where X <= 0.
[[nodiscard]] double scotopic_luminance(const XYZd& xyz) noexcept;

/// The share of the cones: 0 below mesopic luminances, 1 above, linear in Y between. Source: as above.
[[nodiscard]] double cone_share(double luminance_cdm2) noexcept;

struct RodVision {
    double weight = 1.0;      ///< in [0, 1]; 0: as if cones saw everything
    double blue_shift = 1.0;  ///< of what rods see, in [0, 1]; 0: equal-energy white, as the source has it
};

/// c XYZ + (1 - c) V / 2.31 (1, 1, 1 + blue_shift), c = 1 - weight (1 - cone_share(Y)). 2.31 is V / Y of equal-energy
/// white, which so keeps its luminance. Rods' white has the chromaticity (0.25, 0.25) at full shift. Source: of the
/// bluish white, Jensen, Premoze, Shirley, Thompson, Ferwerda & Stark, "Night Rendering", University of Utah technical
/// report UUCS-00-016, 2000. From kMostMesopic_cdm2 on nothing changes.
[[nodiscard]] XYZd seen_with_rods(const XYZd& xyz, const RodVision& rods) noexcept;

/// The same for all good pixels of a picture (pixel_class.h), in place.
/// \throws std::invalid_argument if threads < 0.
void see_with_rods(ImageView<XYZ> picture, const RodVision& rods, int threads);

}  // namespace emulsion
