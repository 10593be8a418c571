#pragma once
// Colour matching with three real lights: how much of each monochromatic primary matches a unit of power at one
// wavelength. A negative amount means that the primary has to be added to the other side of the match.
//
// The functions are derived from those of XYZ, of which they are a linear transform: the columns of xyz_from_rgb are
// the XYZ of the three primaries, in such units that equal amounts of all match the equal-energy spectrum (equal areas
// under rbar, gbar and bbar), and that a unit of red has a luminance coefficient of 1.
//
// History runs the other way: in 1931 rbar, gbar, bbar came first, and XYZ was defined from them by the matrix that
// is still printed, 2.768892 1.751748 1.130160 / 1 4.590700 0.060100 / 0 0.056508 5.594292. It can't be had back to all
// its digits. The chromaticities of the spectrum that today's XYZ functions go back to were written down to four
// decimals, and the lines at 546.1 and 435.8 nm lie between the wavelengths of that table. Derived here are the
// primaries' chromaticities to 8e-5 of the published ones, which is 1 : 4.5888 : 0.06027 for 1 : 4.5907 : 0.0601.

#include <array>
#include <string>
#include <vector>

#include "core/color.h"
#include "core/matrix3.h"
#include "spectrum/observer.h"

namespace emulsion {

/// Wavelengths of the primaries of CIE RGB: red, and the green and blue lines of mercury. Source: CIE 15:2004.
inline constexpr std::array<double, 3> kCieRgbPrimaries_nm = {700.0, 546.1, 435.8};

/// Colour-matching functions rbar, gbar, bbar at first_nm, first_nm + 1, ...; straight lines between them and 0
/// outside.
struct RgbObserver {
    std::string name;
    int first_nm = 0;
    std::vector<RGBd> value;  ///< at least two
    Matrix3 xyz_from_rgb;     ///< row 1: the luminance coefficients

    [[nodiscard]] int last_nm() const noexcept { return first_nm + static_cast<int>(value.size()) - 1; }
};

/// The observer's matches with three monochromatic primaries, red, green, blue, scaled as said above; areas are sums of
/// the tabulated values.
/// \throws std::invalid_argument for a primary that isn't a wavelength inside the observer's range, and for primaries
/// that the observer can't match colours with: two alike, or red of no luminance.
[[nodiscard]] RgbObserver rgb_observer(const Observer& observer, const std::array<double, 3>& primaries_nm);

/// CIE 1931 RGB, 2 degrees, 360-830 nm: cie_1931_2deg() matched with kCieRgbPrimaries_nm.
[[nodiscard]] const RgbObserver& cie_rgb_1931();

/// (rbar, gbar, bbar) at one wavelength; 0 outside the table.
[[nodiscard]] RGBd eval(const RgbObserver& observer, double lambda_nm) noexcept;

}  // namespace emulsion
