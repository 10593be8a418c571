#pragma once
// Colour difference of the Colour Measurement Committee. See spectrum/color_difference.h.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "spectrum/cielab.h"

namespace emulsion {

/// CMC(l:c): dE^2 = (dL / (l SL))^2 + (dC / (c SC))^2 + (dH / SH)^2; 2:1 for what is acceptable, 1:1 for what is just
/// seen. With L, C, h of the reference: SL = 0.511 for L < 16, 0.040975 L / (1 + 0.01765 L) from there;
/// SC = 0.0638 C / (1 + 0.0131 C) + 0.638; SH = SC (F T + 1 - F) with F = sqrt(C^4 / (C^4 + 1900)) and
/// T = 0.56 + |0.2 cos(h + 168)| for h from 164 to 345 degrees, 0.36 + |0.4 cos(h + 35)| elsewhere.
/// Not symmetric. The rounded constants leave steps: SL rises by 2.3e-4 at L = 16, T falls by 1.6e-3 at 164 and 2.3e-3
/// past 345 degrees. A grey reference has F = 0, so that it needs no hue. Source: Clarke, McDonald & Rigg, J. Soc.
/// Dyers Colour. 100, 1984; BS 6923:1988.
struct CmcDifference {
    static constexpr std::string_view kName = "cmc";
    static constexpr std::string_view kHelp = "CMC(l:c), for textiles";
    double l = 2.0;  ///< in (0, inf)
    double c = 1.0;  ///< in (0, inf)
    bool operator==(const CmcDifference&) const = default;

    static constexpr std::array kParameters = {
        Parameter<CmcDifference>{"l", &CmcDifference::l, kPositiveFinite, "", "what lightness is divided by"},
        Parameter<CmcDifference>{"c", &CmcDifference::c, kPositiveFinite, "", "what chroma is divided by"}};
};

[[nodiscard]] double difference(const CmcDifference& method, const Lab& reference, const Lab& sample) noexcept;

}  // namespace emulsion
