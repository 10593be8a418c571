#include "display/hlg_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace emulsion {

namespace {

constexpr float kLeastFloat = std::numeric_limits<float>::min();

}  // namespace

double hlg_system_gamma(double peak_cdm2) noexcept { return 1.2 + 0.42 * std::log10(peak_cdm2 / 1000.0); }

RGBd hlg_scene_light(double gamma, const RGBd& luminance, const RGBd& shown) noexcept {
    const double y = luminance.r * shown.r + luminance.g * shown.g + luminance.b * shown.b;
    if (!(y > 0.0)) return {};
    const double scale = std::pow(y, 1.0 / gamma) / y;
    const auto scene = [&](double component) noexcept { return std::min(scale * component, 1.0); };
    return {scene(shown.r), scene(shown.g), scene(shown.b)};
}

HlgSceneLight::HlgSceneLight(double gamma, const RGBd& luminance)
    : luminance_{static_cast<float>(luminance.r), static_cast<float>(luminance.g), static_cast<float>(luminance.b)},
      scene_luminance_([gamma](double y) { return std::pow(y, 1.0 / gamma); }, kLeastFloat) {}

void HlgSceneLight::operator()(std::span<RGB> shown) const noexcept {
    for (RGB& rgb : shown) {
        const float y = luminance_.r * rgb.r + luminance_.g * rgb.g + luminance_.b * rgb.b;
        // Above 1 by rounding only, where the table has 1.
        const float scale = y >= kLeastFloat ? scene_luminance_(y) / std::min(y, 1.0f) : 0.0f;
        const auto scene = [&](float component) noexcept { return std::min(scale * component, 1.0f); };
        rgb = {scene(rgb.r), scene(rgb.g), scene(rgb.b)};
    }
}

}  // namespace emulsion
