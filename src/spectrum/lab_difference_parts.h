#pragma once
// What the differences that weigh chroma and hue apart are made of.

#include <algorithm>
#include <cmath>

#include "spectrum/cielab.h"

namespace emulsion {

/// Chroma, and the squares of the differences in lightness, chroma and hue; they sum to that of the CIELAB distance.
struct LabDifferenceParts {
    double reference_chroma, squared_lightness, squared_chroma, squared_hue;
};

/// The hue's part is what the other two leave, so that it needs no angle, and is 0 if one of the colours is grey. Never
/// negative: rounding of the difference is cut off.
[[nodiscard]] inline LabDifferenceParts lab_difference_parts(const Lab& reference, const Lab& sample) noexcept {
    const double chroma = std::hypot(reference.a, reference.b);
    const double dl = reference.l - sample.l, da = reference.a - sample.a, db = reference.b - sample.b;
    const double dc = chroma - std::hypot(sample.a, sample.b);
    return {chroma, dl * dl, dc * dc, std::max(da * da + db * db - dc * dc, 0.0)};  // NaN if the first is
}

}  // namespace emulsion
