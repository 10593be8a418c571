#include "display/gamut_clip.h"

#include <algorithm>

#include "display/gamut_rows.h"

namespace emulsion {

RGBd map_gamut(const GamutClip& /*mapper*/, const DisplayGamut& /*gamut*/, const RGBd& linear) noexcept {
    return {std::clamp(linear.r, 0.0, 1.0), std::clamp(linear.g, 0.0, 1.0), std::clamp(linear.b, 0.0, 1.0)};
}

GamutCounts map_gamut(const GamutClip& /*mapper*/, const DisplayGamut& /*gamut*/, std::span<RGB> linear) noexcept {
    return clip_row(linear);
}

}  // namespace emulsion
