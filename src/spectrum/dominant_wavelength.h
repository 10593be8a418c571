#pragma once
// What a chromaticity looks like, seen from a white: the monochromatic light of the same hue, and how near it comes to
// that light.

#include "spectrum/chromaticity.h"
#include "spectrum/spectral_locus.h"

namespace emulsion {

struct DominantWavelength {
    enum class Kind {
        dominant,       ///< the hue is spectral: white and light of lambda_nm mix to it
        complementary,  ///< the hue is a purple: it and light of lambda_nm mix to the white
        none,           ///< the white itself: it has no hue
    };
    Kind kind = Kind::none;
    double lambda_nm = 0.0;  ///< within [violet_nm, red_nm] of the locus; NaN for none
    /// Distance from the white over that of the border in the same direction (the purple line for purples): 0 for the
    /// white, 1 on the locus, more for imaginary colours. Real mixtures of lights next to a slightly concave part of
    /// the locus reach 1 + 5e-4 (CIE 1931).
    double excitation_purity = 0.0;
    Chromaticity border;  ///< where the ray from the white through the colour leaves; the white for none
};

/// Exact for the locus as it is tabulated: monochromatic light within [violet_nm, red_nm] gets its own wavelength and
/// purity 1. Beyond, it gets what its chromaticity, which wanders or turns back, has: for CIE 1931 a wavelength of
/// 698.9 to 699 nm, or a purple next to them, with a purity of 1 to 1e-6.
///
/// Source: CIE 15:2004, section 9.1. By the CIE, chromaticities are those of CIE 1931; any observer's will do if the
/// locus is of the same observer.
/// \throws std::invalid_argument if the white is not inside the spectral locus, or a coordinate is not finite.
[[nodiscard]] DominantWavelength dominant_wavelength(const Chromaticity& chromaticity, const Chromaticity& white,
                                                     const SpectralLocus& locus = cie_1931_spectral_locus());

}  // namespace emulsion
