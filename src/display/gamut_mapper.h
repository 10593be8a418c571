#pragma once
// Gamut mapping: linear RGB of the display from anywhere into [0, 1]^3, where it can be shown.

#include <span>
#include <variant>

#include "core/color.h"
#include "core/named_value.h"
#include "display/display_gamut.h"
#include "display/gamut_clip.h"
#include "display/gamut_counts.h"
#include "display/gamut_desaturate.h"
#include "display/gamut_none.h"
#include "display/gamut_oklab.h"

namespace emulsion {

/// All gamut mappers; the first is the default.
using GamutMapper = std::variant<GamutClip, GamutDesaturate, GamutOklab, GamutNone>;

/// One colour in double precision, the twin. Components are finite, below 2^300; those of a colour in [0, 1]^3 stay as
/// they are, others come out inside but of `none`. Continuous, but for colours at the lightness of black and white.
[[nodiscard]] inline RGBd map_gamut(const GamutMapper& mapper, const DisplayGamut& gamut, const RGBd& linear) noexcept {
    return visit_noexcept([&](const auto& chosen) { return map_gamut(chosen, gamut, linear); }, mapper);
}

/// In place, within 6e-8 of the twin where that leaves a colour in range; colours that are outside by no more than
/// kGamutTolerance are clipped by all, which is within 17 of these tolerances of the twin. Every component comes out in
/// [0, 1], but of `none`; NaN as 0, and infinities as very large. Pixels within the gamut stay as they are, bit for
/// bit, but for -0, which may come out as +0.
[[nodiscard]] inline GamutCounts map_gamut(const GamutMapper& mapper, const DisplayGamut& gamut,
                                           std::span<RGB> linear) noexcept {
    return visit_noexcept([&](const auto& chosen) { return map_gamut(chosen, gamut, linear); }, mapper);
}

}  // namespace emulsion
