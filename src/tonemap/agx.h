#pragma once
// A sigmoid of log luminance, as in the display transform of that name.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = key Y / Ya. x = (log2(L / 0.18) + 10) / 16.5 is 0 ten stops below middle grey and 1 at 6.5 stops above it.
/// y = 1/2 + 2 d / (1 + a |d|^p)^(1/p), d = x - 10/16.5, a so that y(0) = 0 and y(1) = 1; p = 3 below middle grey and
/// 3.25 above; Ld = y^2.2, the power being that of the display that y is encoded for. Middle grey becomes 0.218.
/// From two stops above x = 0 downwards, where y^2.2 falls to 0 at once, Ld goes on as a power of L with the same
/// slope; above x = 1 the curve goes on, to at most 1.0935. Source: Sobotka, AgX, github.com/sobotka/AgX 2022, its
/// sigmoid by Smith. Only the curve is taken, and of luminance: what AgX does to colours before and after it, its inset
/// and outset matrices, looks and gamut, is left out, so that bright colours do not go to white. Exposure is relative
/// to Ya.
struct AgX {
    static constexpr std::string_view kName = "agx";
    static constexpr std::string_view kHelp =
        "sigmoid in stops as of AgX, on luminance, without its treatment of colours";
    static constexpr OperatorTraits kTraits = {};
    float key = 0.18f;  ///< L given to Ya; finite, > 0
    bool operator==(const AgX&) const = default;

    static constexpr std::array kParameters = {
        Parameter<AgX>{"key", &AgX::key, kPositiveFinite, "",
                       "scaled luminance given to the adaptation luminance, larger is brighter"}};
};

[[nodiscard]] Adaptation own_adaptation(const AgX& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const AgX& mapper, const SceneLuminance& luminance, double adaptation_cdm2);

}  // namespace emulsion
