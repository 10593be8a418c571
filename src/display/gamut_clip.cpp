#include "display/gamut_clip.h"

#include <algorithm>
#include <cmath>

namespace emulsion {

namespace {

/// Distance from [0, 1], 0 inside; 0 for NaN.
float excess(float component) noexcept { return std::max({0.0f, -component, component - 1.0f}); }

/// -0 and NaN come out as +0.
float clipped(float component) noexcept {
    const float above = component > 0.0f ? component : 0.0f;
    return above < 1.0f ? above : 1.0f;
}

}  // namespace

GamutCounts map_gamut(const GamutClip& /*mapper*/, std::span<RGB> linear) noexcept {
    GamutCounts counts;
    for (RGB& rgb : linear) {
        const bool nan = std::isnan(rgb.r) || std::isnan(rgb.g) || std::isnan(rgb.b);
        const float largest = std::max({excess(rgb.r), excess(rgb.g), excess(rgb.b)});
        counts.nan += nan ? 1 : 0;
        counts.outside += !nan && largest > kGamutTolerance ? 1 : 0;
        counts.largest_excess = std::max(counts.largest_excess, largest);
        rgb = {clipped(rgb.r), clipped(rgb.g), clipped(rgb.b)};
    }
    return counts;
}

}  // namespace emulsion
