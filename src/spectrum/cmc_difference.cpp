#include "spectrum/cmc_difference.h"

#include <cmath>
#include <numbers>

#include "spectrum/lab_difference_parts.h"

namespace emulsion {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// T. The angle from atan2 lies in [-180, 180]: 164..345 degrees are those from 164 and those up to -15.
double hue_factor(const Lab& reference) noexcept {
    const double degrees = std::atan2(reference.b, reference.a) / kDegree;
    if (degrees >= 164.0 || degrees <= -15.0) return 0.56 + std::abs(0.2 * std::cos((degrees + 168.0) * kDegree));
    return 0.36 + std::abs(0.4 * std::cos((degrees + 35.0) * kDegree));
}

}  // namespace

double difference(const CmcDifference& method, const Lab& reference, const Lab& sample) noexcept {
    const LabDifferenceParts parts = lab_difference_parts(reference, sample);
    const double chroma = parts.reference_chroma;
    const double sl = reference.l < 16.0 ? 0.511 : 0.040975 * reference.l / (1.0 + 0.01765 * reference.l);
    const double sc = 0.0638 * chroma / (1.0 + 0.0131 * chroma) + 0.638;
    const double squared_chroma = chroma * chroma;
    const double f = squared_chroma / std::sqrt(squared_chroma * squared_chroma + 1900.0);
    const double sh = sc * (f * hue_factor(reference) + 1.0 - f);
    const double lightness_scale = method.l * sl, chroma_scale = method.c * sc;
    return std::sqrt(parts.squared_lightness / (lightness_scale * lightness_scale) +
                     parts.squared_chroma / (chroma_scale * chroma_scale) + parts.squared_hue / (sh * sh));
}

}  // namespace emulsion
