#pragma once
// The colours of maps of differences: from black for none by violet, red and orange to pale yellow for the most.

#include <vector>

#include "core/color.h"
#include "display/code_value.h"

namespace emulsion {

/// Perceptually uniform: equal steps of a share are equal steps in CIEDE2000, and lightness rises throughout, so that
/// it also reads in grey and by eyes that don't tell red from green. All colours are inside sRGB.
/// Source: ours. A Catmull-Rom curve through six colours in CIELAB (difference_ramp.cpp), gone along at constant speed.
class DifferenceRamp {
  public:
    DifferenceRamp();

    /// Encoded sRGB in [0, 1], of a share of the scale, held in [0, 1].
    [[nodiscard]] RGBd encoded(double share) const noexcept;
    /// As codes of 8 bits.
    [[nodiscard]] CodeRGB code(double share) const noexcept;

  private:
    std::vector<RGBd> encoded_;  // at equal distances
};

}  // namespace emulsion
