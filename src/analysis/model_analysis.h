#pragma once
// No more than a scene needs: what each transport model would get wrong in a scene, what it costs, and which of them is
// the cheapest that is good enough.
//
// Predicted are colour differences (CIEDE2000, by the rule of spectrum/viewing_conditions.h) over the pixels of a pilot
// (analysis/pilot.h), between its bands of wavelengths and the model's channels on the same paths. All bounces that the
// scene's integrator follows count. Spectral models have no such error, in the mean over many pictures; they have
// colour noise, which the pilot's spectra tell, too.
//
// What a pilot can't see: pixels that it hasn't, and light that none of its paths finds. Dispersion has no channel:
// where more than a little light passes dispersing glass, only spectral models are good enough, whatever the budget.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/pilot.h"
#include "pathtracer/prepared_scene.h"
#include "pathtracer/transport_model.h"
#include "spectrum/error_budget.h"

namespace emulsion {

/// CIEDE2000 over pixels: mean, and what 99 in 100 don't exceed.
struct ColourError {
    double mean = 0.0, p99 = 0.0;
};

struct ModelPrediction {
    TransportModel model;
    std::optional<ColourError> error;  ///< 0 for spectral models; none for models of channels where they don't see
                                       ///< what the light or the film do
    double cost = 1.0;                 ///< relative_cost()
    double noise = 0.0;                ///< root mean square CIEDE2000 of a pixel, at the time that rgb takes for the
                                       ///< scene's samples
    bool good_enough = false;          ///< within the budget
};

struct ModelAnalysis {
    ErrorBudget budget;
    std::vector<ModelPrediction> models;  ///< of channels by cost, then spectral ones by their number of wavelengths
    std::size_t chosen = 0;               ///< the cheapest that is good enough; of spectral models, the least noisy
    double dispersed_share = 0.0;         ///< of the picture's luminance: what passed dispersing glass
    bool disperses = false;               ///< more than kDispersionSeen of it, or of the brightest hundredth of pixels
    std::string only_spectral;            ///< why models of channels can't be used at all; empty: they can
};

/// What is taken for invisible.
inline constexpr double kDispersionSeen = 0.005;

/// Time per sample as a multiple of that of rgb, on the Cornell box: docs/transport-models.md, measured by
/// bench_pathtracer_transport. Fixed numbers, so that the same scene is always rendered by the same model.
[[nodiscard]] double relative_cost(const TransportModel& model);

/// \throws std::invalid_argument as validate() does, and as trace_pilot(). Leaves the scene prepared for the chosen
/// model.
[[nodiscard]] ModelAnalysis analyse_models(PreparedScene& scene, const ErrorBudget& budget,
                                           const PilotOptions& options = {});

/// The decision and its reasons, in two lines, or with another separator between them:
///     rgb-prefiltered: predicted dE00 0.23 mean, 1.59 p99; asked for 1 mean, 3 p99
///     rgb:sRGB 2.53 mean, 12.62 p99; spectral:4 would cost 1.11x
[[nodiscard]] std::string reasons(const ModelAnalysis& analysis, std::string_view separator = "\n");

}  // namespace emulsion
