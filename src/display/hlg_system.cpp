#include "display/hlg_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "display/gamut_counts.h"

namespace emulsion {

namespace {

constexpr float kLeastFloat = std::numeric_limits<float>::min();

}  // namespace

double hlg_system_gamma(double peak_cdm2) noexcept { return 1.2 + 0.42 * std::log10(peak_cdm2 / 1000.0); }

double hlg_black_lift(double gamma, double black) noexcept { return std::sqrt(3.0 * std::pow(black, 1.0 / gamma)); }

RGBd hlg_scene_light(double gamma, const RGBd& luminance, const RGBd& shown) noexcept {
    const double y = luminance.r * shown.r + luminance.g * shown.g + luminance.b * shown.b;
    if (!(y > 0.0)) return {};
    const double grey = std::pow(y, 1.0 / gamma), scale = grey / y;
    const double largest = scale * std::max({shown.r, shown.g, shown.b});
    if (largest <= 1.0) return scale * shown;
    const double kept = std::max(1.0 - grey, 0.0) / (largest - grey);
    const auto scene = [&](double c) noexcept { return std::min(grey + kept * (scale * c - grey), 1.0); };
    return {scene(shown.r), scene(shown.g), scene(shown.b)};
}

HlgSceneLight::HlgSceneLight(double gamma, const RGBd& luminance)
    : gamma_(gamma),
      luminance_(luminance),
      scene_luminance_([gamma](double y) { return std::pow(y, 1.0 / gamma); }, kLeastFloat) {}

std::int64_t HlgSceneLight::operator()(std::span<RGB> shown) const noexcept {
    const RGB luminance{static_cast<float>(luminance_.r), static_cast<float>(luminance_.g),
                        static_cast<float>(luminance_.b)};
    std::int64_t too_bright = 0;
    for (RGB& rgb : shown) {
        const float y = luminance.r * rgb.r + luminance.g * rgb.g + luminance.b * rgb.b;
        // Above 1 by rounding only, where the table has 1.
        const float scale = y >= kLeastFloat ? scene_luminance_(y) / std::min(y, 1.0f) : 0.0f;
        const float largest = scale * std::max({rgb.r, rgb.g, rgb.b});
        if (largest <= 1.0f) {
            rgb = scale * rgb;
            continue;
        }
        if (largest > 1.0f + kGamutTolerance) ++too_bright;
        const RGBd scene = hlg_scene_light(gamma_, luminance_, {rgb.r, rgb.g, rgb.b});
        rgb = {static_cast<float>(scene.r), static_cast<float>(scene.g), static_cast<float>(scene.b)};
    }
    return too_bright;
}

}  // namespace emulsion
