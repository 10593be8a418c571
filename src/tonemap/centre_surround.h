#pragma once
// Automatic dodging and burning: adaptation to the largest neighbourhood of a pixel without much contrast.

#include <array>
#include <string_view>

#include "core/image.h"
#include "core/parameters.h"

namespace emulsion {

/// V1 of the largest of the scales s = 1, 1.6, ..., 1.6^7 px before |V| first exceeds epsilon, with
/// V = (V1 - V2) / (2^phi key / s^2 + V1). V1 is the scaled luminance under a Gaussian of standard deviation
/// alpha s / sqrt(2), V2 under one 1.6 times as wide: the next scale's V1, the last one's of 43 px. On luminances over
/// the log-average the key cancels, and so is no parameter: V = (V1 - V2) / (2^phi / s^2 + V1).
/// Source: Reinhard, Stark, Shirley & Ferwerda, "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002,
/// eq. 5 to 8. Departs from it in that profiles are integrated over pixels (see gaussian_kernel.h) and that scales
/// close to epsilon are blended (see scale_selection.h).
struct CentreSurroundAdaptation {
    static constexpr std::string_view kName = "centre-surround";
    static constexpr std::string_view kHelp = "the largest of eight neighbourhoods without much contrast";
    float phi = 8.0f;            ///< sharpening; in [0, 30]
    float epsilon = 0.05f;       ///< contrast that ends the growth; in (0, 10]
    float alpha = 0.353553391f;  ///< 1 / (2 sqrt 2): two standard deviations of the centre are s / 2; in (0, 10]
    bool operator==(const CentreSurroundAdaptation&) const = default;

    static constexpr std::array kParameters = {
        Parameter<CentreSurroundAdaptation>{"phi",
                                            &CentreSurroundAdaptation::phi,
                                            {0.0, 30.0},
                                            "",
                                            "sharpening: with more, dark neighbourhoods grow wider"},
        Parameter<CentreSurroundAdaptation>{"epsilon",
                                            &CentreSurroundAdaptation::epsilon,
                                            {0.0, 10.0, RangeEnd::open},
                                            "",
                                            "contrast with the surround at which a neighbourhood stops growing"},
        Parameter<CentreSurroundAdaptation>{"alpha",
                                            &CentreSurroundAdaptation::alpha,
                                            {0.0, 10.0, RangeEnd::open},
                                            "",
                                            "size of the centre at every scale"}};
};

/// Over the log-average, as the picture given (relative_luminance.h). Within the tolerance of tone_map_reference() of
/// its twin; the same bits for every number of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> local_luminance(const CentreSurroundAdaptation& adaptation, Image<float> relative_luminance,
                                           int threads);
[[nodiscard]] Image<double> local_luminance_reference(const CentreSurroundAdaptation& adaptation,
                                                      const Image<double>& relative_luminance);

}  // namespace emulsion
