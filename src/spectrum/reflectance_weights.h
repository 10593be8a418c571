#pragma once
// What a reflectance looks like under an illuminant. "White-relative" XYZ is X/Xw, Y/Yw, Z/Zw: (1, 1, 1) for the
// perfect reflector. "Has the RGB colour" means: under the space's illuminant, for the CIE 1931 observer, with the
// perfect reflector at (1, 1, 1).

#include <array>
#include <cstddef>
#include <vector>

#include "core/color.h"
#include "core/matrix3.h"
#include "core/units.h"
#include "spectrum/rgb_space.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// Whole nanometres of the visible range, both ends included.
inline constexpr std::size_t kWholeNanometres = kMaxWavelength_nm - kMinWavelength_nm + 1;

/// Integrals of a reflectance with an illuminant and three functions, as sums over its values at whole nanometres from
/// kMinWavelength_nm to kMaxWavelength_nm with straight lines between. The weights of each sum add up to 1.
struct ReflectanceWeights {
    std::array<std::vector<double>, 3> sum;  ///< kWholeNanometres each
};

/// White-relative XYZ, CIE 1931 observer. Exact for an illuminant with knots at whole nanometres and no jump within the
/// visible. \throws std::invalid_argument if the illuminant is 0 in the visible.
[[nodiscard]] ReflectanceWeights reflectance_weights(const Spectrum& illuminant);

/// The three sums over a reflectance.
[[nodiscard]] std::array<double, 3> weighted_sums(const ReflectanceWeights& weights,
                                                  const Spectrum& reflectance) noexcept;

/// The illuminant of a space: D65 as tabulated (CIE 15:2004, 300-830 nm) if its white is that of D65 to 5e-4 in x and
/// y; for every other white, the mixture of the CIE daylight components that has its chromaticity. \throws
/// std::invalid_argument as daylight() does.
[[nodiscard]] PiecewiseLinearSpectrum illuminant_of(const RgbSpace& space);

/// What uplifts to one space work with.
struct ReflectanceRgb {
    RgbSpace space;
    PiecewiseLinearSpectrum illuminant;
    ReflectanceWeights xyz_weights;  ///< white-relative XYZ of a reflectance
    ReflectanceWeights rgb_weights;  ///< linear RGB of a reflectance; negative in places
    Matrix3 relative_xyz_from_rgb;   ///< white-relative: each row adds up to 1
};

/// \throws std::invalid_argument as illuminant_of and xyz_from_rgb do.
[[nodiscard]] ReflectanceRgb reflectance_rgb(const RgbSpace& space);

}  // namespace emulsion
