#pragma once
// The chromaticities of monochromatic light, and what lies inside them.
//
// The colour-matching functions are straight lines between whole nanometres, so the chromaticity moves on a straight
// line there too (not evenly: by the weights X + Y + Z). The locus is thus exactly a polygonal line, and nothing here
// is interpolated otherwise.
//
// Its far ends are no use as a boundary: the tabulated functions wander there in their last digits (CIE 1931 above 699
// nm), or turn back (CIE 1964 above 701 nm, CIE 2015 above 703 nm). So there are two regions:
//   - the hue circle: the locus from violet_nm() to red_nm(), where the hue seen from equal energy (1/3, 1/3) moves
//     strictly one way, closed by the purple line. Dominant wavelength and purity refer to it.
//   - all real colours: what lights can be mixed to, the convex hull of the whole locus. Inside and outside refer to
//     it. It is a little larger, as the locus is concave in places: by up to 1.5e-4 in x, y (CIE 1931; 2.2e-5 for CIE
//     1964, 8.3e-4 for CIE 2015), always in the violet.

#include <vector>

#include "core/color.h"
#include "spectrum/chromaticity.h"
#include "spectrum/observer.h"

namespace emulsion {

class SpectralLocus {
  public:
    /// \throws std::invalid_argument if X + Y + Z is not positive at some wavelength, or the locus doesn't run around
    /// equal energy.
    explicit SpectralLocus(const Observer& observer);

    /// The ends of the hue circle, whole nm: 360 and 699 nm for CIE 1931, 360 and 701 nm for CIE 1964.
    [[nodiscard]] int violet_nm() const noexcept { return violet_nm_; }
    [[nodiscard]] int red_nm() const noexcept { return violet_nm_ + static_cast<int>(xyz_.size()) - 1; }

    /// Distance in x, y of a chromaticity from the border of all real colours: positive inside, negative outside. On
    /// the border rounding decides (1e-16). NaN for NaN.
    [[nodiscard]] double signed_distance(const Chromaticity& chromaticity) const noexcept;

    /// Where a ray leaves the hue circle.
    struct Crossing {
        enum class Line { spectral, purple } line = Line::spectral;
        double lambda_nm = 0.0;  ///< on the spectral line, whose ends count as part of it; NaN on the purple line
        Chromaticity point;
        double distance = 0.0;  ///< from the origin, in units of the distance of `through`
    };

    /// The ray from `origin` inside the hue circle towards `through`; the last crossing, if there are several.
    /// \throws std::invalid_argument if the origin is not inside the hue circle, a coordinate is not finite, or the two
    /// are the same.
    [[nodiscard]] Crossing crossing(const Chromaticity& origin, const Chromaticity& through) const;

  private:
    std::vector<Chromaticity> hull_;  // of the whole locus
    int violet_nm_ = 0;
    std::vector<XYZd> xyz_;  // of the hue circle, at violet_nm_, violet_nm_ + 1, ...
};

/// The locus of cie_1931_2deg(), made on first use. May be called from many threads.
[[nodiscard]] const SpectralLocus& cie_1931_spectral_locus();

}  // namespace emulsion
