#pragma once
// A logarithm whose base grows with luminance. Scaled luminance L is relative to adaptation.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = Y (1 + b - 0.85)^5 / Ya,  Ld = (peak / 100) ln(1 + L) / (log10(1 + Lmax) ln(2 + 8 (L / Lmax)^(ln b / ln 0.5))):
/// log2 for what is dark, log10 at Lmax, which becomes peak / 100. Only the ratio of luminances counts.
/// Source: Drago, Myszkowski, Annen & Chiba, "Adaptive Logarithmic Mapping For Displaying High Contrast Scenes",
/// Eurographics 2003, eq. 4 (its scale by bias is told below it). Departs from it in three ways. Lmax is of the robust
/// maximum of SceneLuminance. Above it the curve goes on along its tangent in ln L, where the formula would fall again
/// and show the sun darker than its sky. The exponent is kept below 2.678 L / ((1 + L) ln(1 + L)) at Lmax, past which
/// the formula is not monotone: with a bias of 0.85 that begins at Lmax = 9e4.
struct Drago {
    static constexpr std::string_view kName = "drago";
    static constexpr std::string_view kHelp = "adaptive logarithmic mapping";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::nearly_cancels};
    float bias = 0.85f;   ///< b; in (0, 1]
    float peak = 100.0f;  ///< Ldmax: brightness, 100 gives display white to the largest luminance; finite, > 0
    bool operator==(const Drago&) const = default;

    static constexpr std::array kParameters = {
        Parameter<Drago>{
            "bias", &Drago::bias, {0.0, 1.0, RangeEnd::open}, "", "smaller is brighter, 0.7 to 0.9 is usual"},
        Parameter<Drago>{"peak", &Drago::peak, kPositiveFinite, "cd/m^2",
                         "of the display; the largest luminance comes out as peak / 100"}};
};

[[nodiscard]] Adaptation own_adaptation(const Drago& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const Drago& mapper, const SceneLuminance& luminance, double adaptation_cdm2);

}  // namespace emulsion
