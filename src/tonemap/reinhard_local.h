#pragma once
// The local part of photographic tone reproduction. Scaled luminance L has no unit; display luminance Ld is relative: 1
// is display white.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = key Y / log_average;  Ld = L / (1 + V1), V1 = key Ya / log_average. Ya is that of centre-surround, unless chosen
/// otherwise. Details brighter than their surround may come out above 1.
/// Source: Reinhard, Stark, Shirley & Ferwerda, "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002,
/// eq. 9. No white: eq. 4 has it in L, and so not in a scale that depends on Ya alone; nor has the paper one here.
struct ReinhardLocal {
    static constexpr std::string_view kName = "reinhard-local";
    static constexpr std::string_view kHelp = "photographic tone reproduction with automatic dodging and burning";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::nearly_cancels, .monotone = Monotone::locally};
    float key = 0.18f;  ///< L given to the log-average; finite, > 0, or 0: photographic_key()
    bool operator==(const ReinhardLocal&) const = default;

    static constexpr std::array kParameters = {Parameter<ReinhardLocal>{
        "key", &ReinhardLocal::key, kPositiveFinite, "",
        "scaled luminance given to the log-average, larger is brighter; auto: from the range", kAutomatic}};
};

[[nodiscard]] Adaptation own_adaptation(const ReinhardLocal& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const ReinhardLocal& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
