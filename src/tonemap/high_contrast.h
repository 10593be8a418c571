#pragma once
// Keeping the visibility of differences, at every luminance and for every neighbourhood.

#include <string_view>

#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Ld = Y T(Ya) / Ya, T(Ya) = (C(Ya) - C(Ymin)) / (C(Ymax) - C(Ymin)), C of visual_capacity.h; Ya is that of
/// varying-radius, unless chosen otherwise. Needs luminances in cd/m^2. Details brighter than their neighbourhood may
/// come out above 1.
/// Source: Ashikhmin, "A Tone Mapping Algorithm for High Contrast Images", Eurographics Workshop on Rendering 2002, eq.
/// 4 and 5; Pharr & Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4. Departs from them in that Ymin
/// and Ymax are the robust ones of SceneLuminance, T being kept within [0, 1], so that the darkest neighbourhoods
/// come out black, as the least luminance does in the sources; and in that T = 1/2 where both are the same, so that a
/// constant picture is neither black nor white.
struct HighContrast {
    static constexpr std::string_view kName = "high-contrast";
    static constexpr std::string_view kHelp = "keeps visible differences visible everywhere; needs cd/m^2";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::absolute, .monotone = Monotone::locally};
    bool operator==(const HighContrast&) const = default;
};

[[nodiscard]] Adaptation own_adaptation(const HighContrast& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const HighContrast& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
