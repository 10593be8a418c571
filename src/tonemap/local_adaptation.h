#pragma once
// Keeping what can just be seen, for an eye that adapts to each part of the picture.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Ld = s(Ya) Y / peak, s of ContrastScale, for the Ya of each pixel: that of uniform-radius, unless chosen otherwise.
/// Needs luminances in cd/m^2. Details brighter than their neighbourhood may come out above 1. Source: Pharr &
/// Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4; s: see contrast.h.
struct LocalAdaptation {
    static constexpr std::string_view kName = "local-adaptation";
    static constexpr std::string_view kHelp = "as contrast, adapted to each neighbourhood; needs cd/m^2, shows halos";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::absolute, .monotone = Monotone::locally};
    float peak = 100.0f;  ///< luminance of display white, cd/m^2; finite, > 0
    bool operator==(const LocalAdaptation&) const = default;

    static constexpr std::array kParameters = {Parameter<LocalAdaptation>{
        "peak", &LocalAdaptation::peak, kPositiveFinite, "cd/m^2", "luminance of display white"}};
};

[[nodiscard]] Adaptation own_adaptation(const LocalAdaptation& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const LocalAdaptation& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
