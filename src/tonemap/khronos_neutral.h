#pragma once
// A curve that leaves all colours but highlights as they are.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = key Y / Ya. c = 6.25 L^2 for L < 0.08, else L - 0.04, takes off what a dielectric reflects at normal incidence;
/// Ld = c for c < 0.76, else 1 - 0.24^2 / (c - 0.52). Value and slope are continuous at both joins. Limit 1.
/// Source: Khronos Group, "PBR Neutral Tone Mapper" 2024. Departs from it in that the curve is of luminance: there the
/// smallest of R, G, B decides about the first step and the largest about the second, and highlights are desaturated.
/// For greys the two are the same. It is meant for scenes lit so that white is 1, and makes dark ones darker.
struct KhronosNeutral {
    static constexpr std::string_view kName = "khronos-neutral";
    static constexpr std::string_view kHelp = "keeps what is below white, rolls off highlights; on luminance";
    static constexpr OperatorTraits kTraits = {};
    float key = 0.18f;  ///< L given to Ya; finite, > 0
    bool operator==(const KhronosNeutral&) const = default;

    static constexpr std::array kParameters = {
        Parameter<KhronosNeutral>{"key", &KhronosNeutral::key, kPositiveFinite, "",
                                  "scaled luminance given to the adaptation luminance, larger is brighter"}};
};

[[nodiscard]] Adaptation own_adaptation(const KhronosNeutral& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const KhronosNeutral& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
