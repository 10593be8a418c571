#pragma once
// Gamut mapping: linear RGB of the display from anywhere into [0, 1]^3, where it can be shown.

#include <span>
#include <variant>

#include "core/color.h"
#include "core/named_value.h"
#include "display/gamut_clip.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// All gamut mappers; the first is the default.
using GamutMapper = std::variant<GamutClip>;

/// In place. Every component comes out in [0, 1], NaN as 0; pixels within the gamut stay as they are.
[[nodiscard]] inline GamutCounts map_gamut(const GamutMapper& mapper, std::span<RGB> linear) noexcept {
    return visit_noexcept([&](const auto& chosen) { return map_gamut(chosen, linear); }, mapper);
}

}  // namespace emulsion
