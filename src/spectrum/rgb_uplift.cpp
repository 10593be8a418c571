#include "spectrum/rgb_uplift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "spectrum/colorimetry.h"

namespace emulsion {

namespace {

constexpr std::string_view kReflectanceRange = "a number in [0, 1]";
constexpr std::string_view kUnboundedRange = "a number >= 0, twice of which is finite";
constexpr double kLargestUnbounded = 0.5 * std::numeric_limits<double>::max();

void require_components(const RGBd& rgb, double largest, std::string_view expected) {
    const auto require = [&](char name, double value) {
        if (std::isfinite(value) && value >= 0.0 && value <= largest) return;
        throw std::invalid_argument(fmt::format("RGB colour: {} = {}: expected {}", name, value, expected));
    };
    require('r', rgb.r);
    require('g', rgb.g);
    require('b', rgb.b);
}

// An unbounded colour as pbrt-v4 takes it: scale times a reflectance of at most 1/2.
struct ScaledRgb {
    RGBd rgb;
    double scale = 0.0;
};

ScaledRgb scaled_rgb(const RGBd& rgb) {
    require_components(rgb, kLargestUnbounded, kUnboundedRange);
    const double scale = 2.0 * std::max({rgb.r, rgb.g, rgb.b});
    if (scale == 0.0) return {{}, 0.0};
    return {{rgb.r / scale, rgb.g / scale, rgb.b / scale}, scale};
}

}  // namespace

RgbUplift::RgbUplift(const RgbSpace& space, const UpliftMethod& method)
    : space_(reflectance_rgb(space)),
      method_(std::visit(
          [this](const auto& chosen) -> PreparedUplifts<UpliftMethod>::Type { return prepare(chosen, space_); },
          method)) {}

Spectrum RgbUplift::reflectance(const RGBd& rgb) const {
    require_components(rgb, 1.0, kReflectanceRange);
    return std::visit([&](const auto& method) { return Spectrum(method.reflectance(rgb)); }, method_);
}

Spectrum RgbUplift::unbounded(const RGBd& rgb) const {
    const ScaledRgb bounded = scaled_rgb(rgb);
    if (bounded.scale == 0.0) return ConstantSpectrum{0.0};
    return scaled(reflectance(bounded.rgb), bounded.scale);
}

Spectrum RgbUplift::light(const RGBd& rgb) const {
    const ScaledRgb bounded = scaled_rgb(rgb);
    Spectrum spectrum = reflectance(bounded.rgb);
    if (const auto* sigmoid = std::get_if<SigmoidSpectrum>(&spectrum)) {
        // Black: with a scale of 0, any finite sigmoid will do.
        return RgbIlluminantSpectrum{bounded.scale == 0.0 ? SigmoidSpectrum{} : *sigmoid, space_.illuminant,
                                     bounded.scale};
    }
    return product_of(std::move(spectrum), space_.illuminant, bounded.scale);
}

double RgbUplift::light_normalisation() const { return photometric_integral(space_.illuminant); }

RGBd RgbUplift::rgb_of(const Spectrum& reflectance) const noexcept {
    const std::array<double, 3> rgb = weighted_sums(space_.rgb_weights, reflectance);
    return {rgb[0], rgb[1], rgb[2]};
}

SigmoidSpectrum fit_sigmoid(const RGBd& reflectance, const RgbSpace& space) {
    return std::get<SigmoidSpectrum>(RgbUplift(space).reflectance(reflectance));
}

RgbIlluminantSpectrum rgb_illuminant(const RGBd& light, const RgbSpace& space) {
    return std::get<RgbIlluminantSpectrum>(RgbUplift(space).light(light));
}

}  // namespace emulsion
