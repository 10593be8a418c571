#include "display/gamut_desaturate.h"

#include <algorithm>

#include "display/gamut_scan.h"

namespace emulsion {

namespace {

/// The largest t in [0, 1] for which grey + t (component - grey) is in [0, 1]; grey in (0, 1).
double reach(double grey, double component) noexcept {
    if (component < 0.0) return grey / (grey - component);
    if (component > 1.0) return (1.0 - grey) / (component - grey);
    return 1.0;
}

}  // namespace

RGBd map_gamut(const GamutDesaturate& /*mapper*/, const DisplayGamut& gamut, const RGBd& linear) noexcept {
    const auto& [r, g, b] = linear;
    const double grey = gamut.luminance.r * r + gamut.luminance.g * g + gamut.luminance.b * b;
    const double t = std::min({reach(grey, r), reach(grey, g), reach(grey, b)});
    if (t == 1.0) return linear;
    if (!(grey > 0.0)) return {0.0, 0.0, 0.0};
    if (grey >= 1.0) return {1.0, 1.0, 1.0};
    const auto moved = [&](double component) noexcept { return std::clamp(grey + t * (component - grey), 0.0, 1.0); };
    return {moved(r), moved(g), moved(b)};
}

GamutCounts map_gamut(const GamutDesaturate& mapper, const DisplayGamut& gamut, std::span<RGB> linear) noexcept {
    return map_outside_exactly(linear, [&](const RGBd& rgb) noexcept { return map_gamut(mapper, gamut, rgb); });
}

}  // namespace emulsion
