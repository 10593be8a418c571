#pragma once
// Spectra to tristimulus values. Absolute: of a radiance in W m^-2 sr^-1 nm^-1, with Y in cd/m^2. Relative: of a
// reflectance under an illuminant, with Y = 1 for the perfect reflector. Integrals are over the range of the observer,
// exact for piecewise linear spectra, and to a relative 1e-9 for the smooth ones.

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
/// \throws std::invalid_argument as validate(Spectrum) does, and for an illuminant that is 0 in the visible.
[[nodiscard]] XYZd xyz_of_reflectance(const Spectrum& reflectance, const Spectrum& illuminant,
                                      const Observer& observer = cie_1931_2deg());

}  // namespace emulsion
