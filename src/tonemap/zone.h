#pragma once
// The zone system. The eleven zones 0 to X are one stop apart; V is middle grey, 0.18 of display white, so that VII is
// 0.72 of it. Scaled luminance L is relative to display white, before compression.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// L = p Y / grey, p = 0.18 * 2^(zone - 5): the grey luminance is placed on its zone. Where the picture's range fits,
/// Ld = L exactly. Where the robust largest L, Lmax, is above white, what is brighter than the grey is compressed:
///     Ld = p + (1 - p) t (1 + t / w^2) / (1 + t),  t = (L - p) / (1 - p),  w = t of Lmax,  for L > p.
/// That leaves the grey on its zone, begins with slope 1, rises for every L and gives white to Lmax; as Lmax nears
/// white it becomes Ld = L. Darker than the grey all is linear: a display shows 0 as 0, so that there is nothing to
/// fit. Zones past VII cannot be asked for: where V is 0.18 of white they are above it. Source: Adams, "The Negative",
/// 1948 (zones and placement). The shoulder is ours, and has the form of Reinhard et al. 2002, eq. 4.
struct ZoneSystem {
    static constexpr std::string_view kName = "zone";
    static constexpr std::string_view kHelp = "zone system, a grey luminance is placed on a zone";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::nearly_cancels};
    float grey = 0.0f;  ///< luminance that is placed, cd/m^2; finite, > 0, or 0: Ya
    float zone = 5.0f;  ///< zone that it is placed on; in [0, 7]
    bool operator==(const ZoneSystem&) const = default;

    static constexpr std::array kParameters = {
        Parameter<ZoneSystem>{"grey", &ZoneSystem::grey, kPositiveFinite, "cd/m^2",
                              "luminance to be placed; auto: the adaptation luminance, as of --adaptation spot",
                              kAutomatic},
        Parameter<ZoneSystem>{
            "zone", &ZoneSystem::zone, {0.0, 7.0}, "", "zone that it is placed on, 5 is middle grey"}};
};

/// How many zones, of one stop each, the robust range of a picture spans; 0 if no pixel is positive.
[[nodiscard]] double dynamic_range_zones(const SceneLuminance& luminance);

[[nodiscard]] Adaptation own_adaptation(const ZoneSystem& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const ZoneSystem& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
