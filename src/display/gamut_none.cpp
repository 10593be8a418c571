#include "display/gamut_none.h"

#include <cmath>

#include "display/gamut_scan.h"

namespace emulsion {

RGBd map_gamut(const GamutNone& /*mapper*/, const DisplayGamut& /*gamut*/, const RGBd& linear) noexcept {
    return linear;
}

GamutCounts map_gamut(const GamutNone& /*mapper*/, const DisplayGamut& /*gamut*/, std::span<RGB> linear) noexcept {
    const auto number = [](float v) noexcept { return std::isnan(v) ? 0.0f : v; };
    return map_outside(linear, [&](const RGB& rgb, float /*excess*/) noexcept {
        return RGB{number(rgb.r), number(rgb.g), number(rgb.b)};
    });
}

}  // namespace emulsion
