#include "spectrum/dominant_wavelength.h"

#include <limits>

namespace emulsion {

DominantWavelength dominant_wavelength(const Chromaticity& chromaticity, const Chromaticity& white,
                                       const SpectralLocus& locus) {
    using Line = SpectralLocus::Crossing::Line;
    if (chromaticity == white) {
        // The white is still to be checked: any ray from it does that.
        (void)locus.crossing(white, {white.x + 1.0, white.y});
        return {DominantWavelength::Kind::none, std::numeric_limits<double>::quiet_NaN(), 0.0, white};
    }
    const SpectralLocus::Crossing ahead = locus.crossing(white, chromaticity);
    const double purity = 1.0 / ahead.distance;
    if (ahead.line == Line::spectral) {
        return {DominantWavelength::Kind::dominant, ahead.lambda_nm, purity, ahead.point};
    }
    // No line through the white meets the purple line twice, so behind the white is the spectral locus.
    const Chromaticity opposite = {2.0 * white.x - chromaticity.x, 2.0 * white.y - chromaticity.y};
    const SpectralLocus::Crossing behind = locus.crossing(white, opposite);
    return {DominantWavelength::Kind::complementary, behind.lambda_nm, purity, ahead.point};
}

}  // namespace emulsion
