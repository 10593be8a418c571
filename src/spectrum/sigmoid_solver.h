#pragma once
// The sigmoid reflectance that has given tristimulus values; all XYZ here are white-relative (reflectance_weights.h).
// Source of the function space: Jakob & Hanika, "A Low-Dimensional Function Space for Efficient Spectral Upsampling",
// EG 2019. The solver is ours: Levenberg-Marquardt on CIELAB residuals, following the colour from mid grey outwards.

#include "core/color.h"
#include "spectrum/reflectance_weights.h"
#include "spectrum/spectrum.h"

namespace emulsion {

/// The sigmoid whose CIELAB difference from `target` is least: below 1e-9 where a sigmoid reaches the colour (1e-3 for
/// the darkest saturated ones), else a local minimum with bounded coefficients. Not for the ideal black and white,
/// which only infinite coefficients reach. `weights` are those of XYZ.
[[nodiscard]] SigmoidSpectrum solve_sigmoid(const ReflectanceWeights& weights, const XYZd& target) noexcept;

/// How to go on from a sigmoid that is close already.
struct SigmoidSearch {
    SigmoidSpectrum start;              ///< finite
    double accepted_difference = 1e-9;  ///< CIELAB; ends when this is reached, and
    double least_gain = 0.0;            ///< when a step lowers the cost by less than this part of it
    double penalty = 0.0;               ///< cost = squared CIELAB difference + penalty * squared centred coefficients
    int evaluations = 100;              ///< and at the latest after as many
};

/// Searches for less cost until an end is reached. A penalty keeps the coefficients of colours beyond reach moderate,
/// and so neighbouring colours' alike.
[[nodiscard]] SigmoidSpectrum improved_sigmoid(const ReflectanceWeights& weights, const XYZd& target,
                                               const SigmoidSearch& search) noexcept;

}  // namespace emulsion
