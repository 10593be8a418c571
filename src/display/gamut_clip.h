#pragma once
// Clipping into the display's gamut, component by component.

#include <span>
#include <string_view>

#include "core/color.h"
#include "display/display_gamut.h"
#include "display/gamut_counts.h"

namespace emulsion {

/// Each component of linear RGB to the nearest value in [0, 1]. Changes hue where components are clipped unequally.
struct GamutClip {
    static constexpr std::string_view kName = "clip";
    static constexpr std::string_view kHelp = "each component to the nearest value in range";
    bool operator==(const GamutClip&) const = default;
};

/// As map_gamut() in display/gamut_mapper.h, of one colour in double precision and of many in single.
[[nodiscard]] RGBd map_gamut(const GamutClip& mapper, const DisplayGamut& gamut, const RGBd& linear) noexcept;
[[nodiscard]] GamutCounts map_gamut(const GamutClip& mapper, const DisplayGamut& gamut, std::span<RGB> linear) noexcept;

}  // namespace emulsion
