#pragma once
// How scene-referred colours are looked at when their differences are measured: the one rule that puts high dynamic
// range on the scale of CIELAB, and on that of ICtCp. XYZ is scene-referred, Y in cd/m^2.
//
// Both scales know a white and nothing of scenes: CIELAB ends at it, ICtCp has light as a display shows it. So a
// picture is taken as shown with a luminance Yw as its white. Yw is such that the log-average of the picture's
// luminance is middle grey, as a camera would meter it; of two pictures, the reference's. Then
//   - negative X, Y or Z, of noise or of colours that no light has, are 0: no display shows less than nothing;
//   - for CIELAB, what is brighter than white is brought to its luminance, its chromaticity kept, as the display does
//     that can't show more;
//   - for ICtCp, Yw is shown at 203 cd/m^2, and what is then brighter than 10000 cd/m^2 is brought to that likewise.
// Nothing is adapted: colours are looked at as they are, beside the white.

#include "core/color.h"
#include "core/middle_grey.h"
#include "spectrum/cielab.h"
#include "spectrum/ictcp.h"
#include "spectrum/observer.h"

namespace emulsion {

struct ViewingConditions {
    XYZd white;                         ///< of CIELAB; Y = 1
    double white_luminance_cdm2 = 1.0;  ///< Yw; in [1e-30, 1e30]
    bool operator==(const ViewingConditions&) const = default;
};

/// \throws std::invalid_argument naming field, value and range.
void validate(const ViewingConditions& viewing);

/// The white that is taken unless another is asked for: D65, Y = 1. For the 1931 observer by its customary
/// chromaticity, which is that of the white of Rec. 709 and sRGB, so that their greys are grey; for others the integral
/// of its spectrum.
[[nodiscard]] XYZd default_white(const Observer& observer);

/// Yw of a picture whose luminance has this log-average: exp(mean of ln Y) over the pixels with Y > 0; zeros, negative
/// and non-finite pixels are left out of both sum and count, as everywhere (tonemap/luminance_statistics.h).
[[nodiscard]] constexpr double white_luminance_of_log_average(double log_average_cdm2) noexcept {
    return log_average_cdm2 / kMiddleGrey;
}

/// XYZ without negative components, and with Y of at most `most`, chromaticity kept. All in one unit.
[[nodiscard]] XYZd shown_within(const XYZd& xyz, double most) noexcept;

/// CIELAB and ICtCp by the rule above. NaN for NaN; infinite light has neither.
[[nodiscard]] Lab lab_as_viewed(const XYZd& xyz_cdm2, const ViewingConditions& viewing) noexcept;
[[nodiscard]] ICtCp ictcp_as_viewed(const XYZd& xyz_cdm2, const ViewingConditions& viewing);

}  // namespace emulsion
