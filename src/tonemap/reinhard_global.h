#pragma once
// The global part of photographic tone reproduction. Scaled luminance L is dimensionless: 1 at display white for small
// L and infinite white. Display luminance Ld is relative: 1 is display white.

#include <array>
#include <limits>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = key Y / Ya;  Ld = L (1 + L / white^2) / (1 + L): exactly 1 at L = white, and rising for every white. Ya is the
/// log-average, unless chosen otherwise. Luminances past `white` come out above 1.
/// Source: Reinhard, Stark, Shirley & Ferwerda, "Photographic Tone Reproduction for Digital Images", SIGGRAPH 2002,
/// eq. 1, 2, 4. Departs from it in the log-average (see LuminanceStatistics) and in the largest luminance, for which it
/// takes the robust one of SceneLuminance.
struct ReinhardGlobal {
    static constexpr std::string_view kName = "reinhard-global";
    static constexpr std::string_view kHelp = "photographic tone reproduction, one curve for all pixels";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::nearly_cancels};
    float key = 0.18f;                                     ///< L given to Ya; finite, > 0, or 0: photographic_key()
    float white = std::numeric_limits<float>::infinity();  ///< smallest L shown as white; > 0, or 0: robust largest
    bool operator==(const ReinhardGlobal&) const = default;

    static constexpr std::array kParameters = {
        Parameter<ReinhardGlobal>{
            "key", &ReinhardGlobal::key, kNotNegativeFinite, "",
            "scaled luminance given to the adaptation luminance, larger is brighter; auto: from the range", "auto"},
        Parameter<ReinhardGlobal>{
            "white", &ReinhardGlobal::white, kNotNegative, "",
            "smallest scaled luminance shown as display white; auto: the robust largest, past which a thousandth lie",
            "auto"}};
};

/// 0.18 * 4^((2 log2 Lav - log2 Lmin - log2 Lmax) / (log2 Lmax - log2 Lmin)), the robust ends taken; 0.18 if they are
/// the same. Source: Reinhard, "Parameter Estimation for Photographic Tone Reproduction", J. of Graphics Tools 7(1),
/// 2003, eq. 4.
[[nodiscard]] double photographic_key(const SceneLuminance& luminance);

/// Ld for a scaled luminance L in [0, 1e100] and a white > 0; the curve alone.
[[nodiscard]] double photographic_curve(double scaled_luminance, double white) noexcept;

[[nodiscard]] Adaptation own_adaptation(const ReinhardGlobal& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const ReinhardGlobal& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
