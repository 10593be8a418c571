#pragma once
// Spectra to tristimulus values. Absolute: of a radiance in W m^-2 sr^-1 nm^-1, with Y in cd/m^2. Relative: of a
// reflectance under an illuminant, with Y = 1 for the perfect reflector. Integrals are over the range of the observer,
// whose functions are straight lines between their tabulated values, and as accurate as spectrum/integral.h says; lines
// without width count. The sums are what many programs and tables have in their place.

#include "core/color.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// Integral of S ybar dlambda over nm, CIE 1931, WITHOUT the factor 683: what pbrt-v4 divides light spectra by.
/// \throws std::invalid_argument as validate(Spectrum) does.
[[nodiscard]] double photometric_integral(const Spectrum& spectrum);

/// What a light's spectrum is divided by, so that the same scene means the same picture as in pbrt-v4: the photometric
/// integral, but for an RgbIlluminantSpectrum that of its illuminant alone, so that colours keep their luminance. The
/// absolute radiance of a light with the scene's scale s is spectrum * s / (kLuminousEfficacy *
/// light_normalisation(spectrum)); a spectrum that is its own normalisation then has s cd/m^2. 0 for a spectrum that is
/// 0 in the visible: the caller decides what that means.
/// \throws std::invalid_argument as validate(Spectrum) does.
[[nodiscard]] double light_normalisation(const Spectrum& spectrum);

/// 683 lm/W times the integrals of S with the observer's functions; Y is in cd/m^2 for S in W m^-2 sr^-1 nm^-1.
/// \throws std::invalid_argument as validate(Spectrum) does.
[[nodiscard]] XYZd xyz_of_radiance(const Spectrum& radiance, const Observer& observer = cie_1931_2deg());

/// Integrals of reflectance * illuminant over that of the illuminant with ybar: Y = 1 for the perfect reflector.
/// \throws std::invalid_argument as validate(Spectrum) does, and for an illuminant that is 0 in the visible, or whose
/// luminance is beyond what a double holds.
[[nodiscard]] XYZd xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant,
                                      const Observer& observer = cie_1931_2deg());

/// The same by a plain sum over first_nm, first_nm + step_nm, ... up to last_nm, all of weight 1, divided by that of
/// the illuminant with ybar; reflectance, illuminant and observer at each wavelength as eval gives them.
/// Source: CIE 15:2004, section 7.1, which takes 360-830 nm by 1 nm; ASTM E308 and most programs 380-780 nm.
/// \throws std::invalid_argument as validate(Spectrum) does; for spectra with lines without width, which no sum can
/// see; for an illuminant that is 0 in the sum; and unless the three numbers are finite and in order, the step > 0.
[[nodiscard]] XYZd xyz_by_summation(const Spectrum& reflectance, const Spectrum& illuminant,
                                    const Observer& observer = cie_1931_2deg(), double first_nm = 380.0,
                                    double last_nm = 780.0, double step_nm = 1.0);

/// 683 lm/W times the sum of radiance and observer times step_nm: Y in cd/m^2 for W m^-2 sr^-1 nm^-1.
/// \throws std::invalid_argument as xyz_by_summation does.
[[nodiscard]] XYZd xyz_of_radiance_by_summation(const Spectrum& radiance, const Observer& observer = cie_1931_2deg(),
                                                double first_nm = 380.0, double last_nm = 780.0, double step_nm = 1.0);

}  // namespace emulsion
