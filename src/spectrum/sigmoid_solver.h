#pragma once
// The sigmoid reflectance that has given tristimulus values. "White-relative" XYZ is X/Xw, Y/Yw, Z/Zw: (1, 1, 1) for
// the perfect reflector.
// Source of the function space: Jakob & Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling",
// EG 2019. The solver is ours: Levenberg-Marquardt on CIELAB residuals, following the colour from mid grey outwards.

#include <array>
#include <vector>

#include "core/color.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// Integrals of a reflectance with an illuminant and an observer, as sums over its values at whole nanometres from
/// kMinWavelength_nm to kMaxWavelength_nm with straight lines between. The weights of each sum add up to 1, so that
/// white-relative XYZ results.
struct ReflectanceWeights {
    std::array<std::vector<double>, 3> xyz;
};

/// CIE 1931 observer. Exact for an illuminant with knots at whole nanometres and no jump within the visible.
/// \throws std::invalid_argument if the illuminant is 0 in the visible.
[[nodiscard]] ReflectanceWeights reflectance_weights(const Spectrum& illuminant);

/// White-relative XYZ of a reflectance.
[[nodiscard]] XYZd relative_xyz(const ReflectanceWeights& weights, const Spectrum& reflectance) noexcept;

/// The sigmoid whose CIELAB difference from `target`, white-relative XYZ, is least: below 1e-9 where a sigmoid reaches
/// the colour (1e-3 for the darkest saturated ones), else a local minimum with bounded coefficients. Not for the ideal
/// black and white, which only infinite coefficients reach.
[[nodiscard]] SigmoidSpectrum solve_sigmoid(const ReflectanceWeights& weights, const XYZd& target) noexcept;

}  // namespace emulsion
