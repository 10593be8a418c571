#include "spectrum/cie94_difference.h"

#include <cmath>

#include "spectrum/lab_difference_parts.h"

namespace emulsion {

namespace {

struct Weights {
    double lightness, chroma, hue;
};

double cie94(const Weights& weights, const Lab& reference, const Lab& sample) noexcept {
    const LabDifferenceParts parts = lab_difference_parts(reference, sample);
    const double sc = 1.0 + weights.chroma * parts.reference_chroma, sh = 1.0 + weights.hue * parts.reference_chroma;
    return std::sqrt(parts.squared_lightness / (weights.lightness * weights.lightness) +
                     parts.squared_chroma / (sc * sc) + parts.squared_hue / (sh * sh));
}

}  // namespace

double difference(const Cie94GraphicDifference& /*method*/, const Lab& reference, const Lab& sample) noexcept {
    return cie94({1.0, 0.045, 0.015}, reference, sample);
}

double difference(const Cie94TextileDifference& /*method*/, const Lab& reference, const Lab& sample) noexcept {
    return cie94({2.0, 0.048, 0.014}, reference, sample);
}

}  // namespace emulsion
