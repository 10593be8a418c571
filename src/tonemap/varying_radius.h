#pragma once
// Adaptation to a neighbourhood that is as large as it can be without much contrast.

#include <array>
#include <string_view>

#include "core/image.h"
#include "core/parameters.h"

namespace emulsion {

/// B_s of the largest s = 1, 2, 4, ..., 32 px before the local contrast |lc| = |B_s - B_2s| / B_s first reaches
/// `contrast`; B_s is the luminance under a Gaussian of standard deviation s / 4, so that s is about its diameter.
/// Source: Ashikhmin, "A Tone Mapping Algorithm for High Contrast Images", Eurographics Workshop on Rendering 2002,
/// section 4.2; Pharr & Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4. Departs from them in the
/// steps of s, in that 0 / 0 is 0, and in that scales close to the limit are blended (see scale_selection.h). Where
/// even s = 1 reaches it, the pixel itself is taken, as by PBRT.
struct VaryingRadiusAdaptation {
    static constexpr std::string_view kName = "varying-radius";
    static constexpr std::string_view kHelp = "the largest neighbourhood, up to 32 px, without much contrast";
    float contrast = 0.5f;  ///< in (0, 10]
    bool operator==(const VaryingRadiusAdaptation&) const = default;

    static constexpr std::array kParameters = {
        Parameter<VaryingRadiusAdaptation>{"contrast",
                                           &VaryingRadiusAdaptation::contrast,
                                           {0.0, 10.0, RangeEnd::open},
                                           "",
                                           "local contrast at which a neighbourhood stops growing"}};
};

/// Over the log-average, as the picture given (relative_luminance.h). Within the tolerance of tone_map_reference() of
/// its twin; the same bits for every number of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> local_luminance(const VaryingRadiusAdaptation& adaptation, Image<float> relative_luminance,
                                           int threads);
[[nodiscard]] Image<double> local_luminance_reference(const VaryingRadiusAdaptation& adaptation,
                                                      const Image<double>& relative_luminance);

}  // namespace emulsion
