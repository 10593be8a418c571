#pragma once
// Integrals over the wavelength, on the union of the knots of everything that is integrated, and not on a grid. Units
// are those of the spectra times nm.
//
// Relative error, of the integral of the absolute value: 1e-12 for constants, tables and daylight, their sums, and
// their products up to degree 15 (of two lines 2), jumps included; 1e-9 with blackbodies, sigmoids and Gaussian lines,
// however steep or narrow. Lines without width count with their power, those at the ends of the range too.

#include <functional>
#include <initializer_list>
#include <vector>

#include "core/color.h"
#include "spectrum/observer.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// Where an integral from from_nm to to_nm has to be cut: the knots, and what is steep without one (sigmoids); strictly
/// between the two, strictly increasing.
[[nodiscard]] std::vector<double> integration_cuts_nm(const Spectrum& spectrum, double from_nm, double to_nm);

using SpectrumReferences = std::initializer_list<std::reference_wrapper<const Spectrum>>;

/// \throws std::invalid_argument as validate(Spectrum) does; unless from_nm and to_nm are finite and in order.
[[nodiscard]] double integral(const Spectrum& spectrum, double from_nm, double to_nm);

/// Of the product of any number of spectra: integral_of_product({reflectance, illuminant}, 380, 780).
/// \throws std::invalid_argument as integral does, and for lines without width at one wavelength in two factors.
[[nodiscard]] double integral_of_product(SpectrumReferences factors, double from_nm, double to_nm);

/// Of the product times each of the observer's functions, over the observer's range; without a factor such as 683.
/// \throws std::invalid_argument as integral_of_product does.
[[nodiscard]] XYZd integral_with_observer(SpectrumReferences factors, const Observer& observer);

}  // namespace emulsion
