#include "spectrum/hue.h"

#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

ChromaHue chroma_hue_of(const Chromatic& chromatic) noexcept {
    const auto [first, second] = chromatic;
    if (first == 0.0 && second == 0.0) return {};  // also where zeros are negative: atan2 tells them apart
    double hue_deg = kDegrees * std::atan2(second, first);
    if (hue_deg < 0.0) hue_deg += 360.0;
    if (hue_deg >= 360.0) hue_deg = 0.0;  // the sum was rounded up
    return {std::hypot(first, second), hue_deg};
}

Chromatic chromatic_of(const ChromaHue& polar) noexcept {
    const double hue = polar.hue_deg / kDegrees;
    return {polar.chroma * std::cos(hue), polar.chroma * std::sin(hue)};
}

}  // namespace emulsion
