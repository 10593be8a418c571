#pragma once
// Clipping into the display's gamut, component by component.

#include <span>
#include <string_view>

#include "core/color.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Each component of linear RGB to the nearest value in [0, 1]. Changes hue where components are clipped unequally.
struct GamutClip {
    static constexpr std::string_view kName = "clip";
    static constexpr std::string_view kHelp = "each component to the nearest value in range";
    bool operator==(const GamutClip&) const = default;
};

/// In place; every component comes out in [0, 1], NaN and -0 as +0.
[[nodiscard]] GamutCounts map_gamut(const GamutClip& mapper, std::span<RGB> linear) noexcept;

}  // namespace emulsion
