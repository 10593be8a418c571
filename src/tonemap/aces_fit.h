#pragma once
// A rational function that looks like the film curve of ACES.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = key Y / Ya,  Ld = L (2.51 L + 0.03) / (L (2.43 L + 0.59) + 0.14): 0.8038 at L = 1, 0.267 at L = 0.18, slope
/// 0.214 at 0, 1 at L = 7.24, limit 1.033. Source: Narkowicz, "ACES Filmic Tone Mapping Curve",
/// knarkowicz.wordpress.com 2016: a fit to the ACES 1.0 rendering for Rec. 709 displays, brighter than it by 1/0.6; a
/// key of 0.108 gives that of ACES. Departs from it in that the curve is of luminance, not of each of R, G, B, so that
/// bright colours do not go to white, that it is not cut off at 1, and that exposure is relative to Ya.
struct AcesFit {
    static constexpr std::string_view kName = "aces-fit";
    static constexpr std::string_view kHelp = "film curve like that of ACES, on luminance";
    static constexpr OperatorTraits kTraits = {};
    float key = 0.18f;  ///< L given to Ya; finite, > 0
    bool operator==(const AcesFit&) const = default;

    static constexpr std::array kParameters = {
        Parameter<AcesFit>{"key", &AcesFit::key, kPositiveFinite, "",
                           "scaled luminance given to the adaptation luminance, larger is brighter"}};
};

[[nodiscard]] Adaptation own_adaptation(const AcesFit& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const AcesFit& mapper, const SceneLuminance& luminance, double adaptation_cdm2);

}  // namespace emulsion
