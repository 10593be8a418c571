#pragma once
// A film curve with toe, straight part and shoulder, made for a game.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = key Y / Ya,  Ld = h(2 L) / h(2 white),  h(x) = (x (A x + C B) + D E) / (x (A x + B) + D F) - E / F with A =
/// 0.15, B = 0.50, C = 0.10, D = 0.20, E = 0.02, F = 0.30: exactly 1 at L = white, slope 0.278 / h(2 white) at 0, limit
/// 0.933 / h(2 white). Luminances past `white` come out above 1.
/// Source: Hable, "Uncharted 2: HDR Lighting", Game Developers Conference 2010, section "Filmic Tonemapping", and
/// "Filmic Tonemapping Operators", filmicworlds.com (filmicgames.com then), 2010; its W = 11.2 is 2 L, as its exposure
/// bias of 2 is not applied to it. Departs from it in that the curve is of luminance, not of each of R, G, B, and that
/// exposure is relative to Ya.
struct HableFilmic {
    static constexpr std::string_view kName = "hable";
    static constexpr std::string_view kHelp = "film curve of Uncharted 2, on luminance";
    static constexpr OperatorTraits kTraits = {};
    float key = 0.18f;   ///< L given to Ya; finite, > 0
    float white = 5.6f;  ///< L mapped to display white; finite, > 0
    bool operator==(const HableFilmic&) const = default;

    static constexpr std::array kParameters = {
        Parameter<HableFilmic>{"key", &HableFilmic::key, kPositiveFinite, "",
                               "scaled luminance given to the adaptation luminance, larger is brighter"},
        Parameter<HableFilmic>{"white", &HableFilmic::white, kPositiveFinite, "",
                               "scaled luminance shown as display white"}};
};

[[nodiscard]] Adaptation own_adaptation(const HableFilmic& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const HableFilmic& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
