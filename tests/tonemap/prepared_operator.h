#pragma once
// An operator that has seen a picture, as the tests of single operators ask it.

#include "core/image.h"
#include "tonemap/tone_mapper.h"

namespace emulsion {

/// Under one adaptation luminance, in double precision: Ld of a luminance in cd/m^2.
struct PreparedOperator {
    ToneReproduction reproduction;
    double adaptation_cdm2 = 0.0;

    PreparedOperator(const ToneMapper& mapper, const Image<XYZ>& scene, double adaptation)
        : reproduction(prepare(mapper, SceneLuminance(scene.view(), 1), adaptation)), adaptation_cdm2(adaptation) {}

    [[nodiscard]] double operator()(double luminance_cdm2) const { return luminance_cdm2 * scale(luminance_cdm2); }
    /// Ld / Y.
    [[nodiscard]] double scale(double luminance_cdm2) const {
        return reproduction.scale(luminance_cdm2, adaptation_cdm2);
    }
    /// dLd / dY, by a central difference over 2e-6 of the luminance: exact to about 1e-9 of the scale.
    [[nodiscard]] double slope(double luminance_cdm2) const {
        const double step = 1e-6 * luminance_cdm2;
        return ((*this)(luminance_cdm2 + step) - (*this)(luminance_cdm2 - step)) / (2.0 * step);
    }
};

}  // namespace emulsion
