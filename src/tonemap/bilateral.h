#pragma once
// Adaptation to the neighbours that are about as bright as a pixel itself: averages that stop at edges.

#include <array>
#include <string_view>

#include "core/image.h"
#include "core/parameters.h"

namespace emulsion {

/// 10^base, base the bilateral average of log10 luminance: each pixel q of a square about p counts with
/// exp(-|p - q|^2 / (2 sigma_space^2)) exp(-(log10 Yp - log10 Yq)^2 / (2 sigma_range^2)). The square reaches as far as
/// three sigma_space. A luminance of 0 counts as the least positive one.
/// Source: Tomasi & Manduchi, "Bilateral Filtering for Gray and Color Images", ICCV 1998; Durand & Dorsey, "Fast
/// Bilateral Filtering for the Display of High-Dynamic-Range Images", SIGGRAPH 2002, whose sigmas are the defaults.
struct BilateralAdaptation {
    static constexpr std::string_view kName = "bilateral";
    static constexpr std::string_view kHelp = "those neighbours that are about as bright as the pixel";
    float sigma_space = 0.02f;  ///< of the longer side; in [0.005, 1]
    float sigma_range = 0.4f;   ///< in decades; in [0.1, 10]
    bool operator==(const BilateralAdaptation&) const = default;

    static constexpr std::array kParameters = {Parameter<BilateralAdaptation>{"sigma-space",
                                                                              &BilateralAdaptation::sigma_space,
                                                                              {0.005, 1.0},
                                                                              "of the longer side",
                                                                              "width of the neighbourhood"},
                                               Parameter<BilateralAdaptation>{"sigma-range",
                                                                              &BilateralAdaptation::sigma_range,
                                                                              {0.1, 10.0},
                                                                              "decades",
                                                                              "how much the neighbours may differ"}};
};

/// Over the log-average, as the picture given (relative_luminance.h). Fast by a grid (bilateral_grid.h); within the
/// tolerance of tone_map_reference() of its twin, which takes every pixel of the square. The same bits for every number
/// of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> local_luminance(const BilateralAdaptation& adaptation, Image<float> relative_luminance,
                                           int threads);
[[nodiscard]] Image<double> local_luminance_reference(const BilateralAdaptation& adaptation,
                                                      const Image<double>& relative_luminance);

}  // namespace emulsion
