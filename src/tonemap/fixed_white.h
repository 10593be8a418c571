#pragma once
// A luminance chosen by the user to display white.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Ld = scale Y / white: linear; the same exposure for every picture, so that pictures can be compared. What is
/// brighter comes out above 1. Source: Pharr & Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4 (the
/// strip of three exposures).
struct FixedWhite {
    static constexpr std::string_view kName = "fixed";
    static constexpr std::string_view kHelp = "linear, a given luminance becomes display white";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::absolute};
    float white = 100.0f;  ///< luminance that becomes display white at scale 1, cd/m^2; finite, > 0
    float scale = 1.0f;    ///< of display luminance; finite, > 0
    bool operator==(const FixedWhite&) const = default;

    static constexpr std::array kParameters = {Parameter<FixedWhite>{"white", &FixedWhite::white, kPositiveFinite,
                                                                     "cd/m^2", "luminance that becomes display white"},
                                               Parameter<FixedWhite>{"scale", &FixedWhite::scale, kPositiveFinite, "",
                                                                     "of what comes out: 2 is twice as bright"}};
};

[[nodiscard]] Adaptation own_adaptation(const FixedWhite& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const FixedWhite& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
