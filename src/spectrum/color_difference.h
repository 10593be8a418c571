#pragma once
// Colour differences between two CIELAB colours, the reference and the sample, under the same white. 0 for equal ones;
// about 1 is just seen side by side. Meant for surfaces and L* of 0..100; outside, the formulas go on. NaN in a colour
// gives NaN.
//
// CIE94 and CMC weigh by the reference alone, so that swapping the two changes the number; the others are symmetric.
// For high dynamic range see spectrum/itp_difference.h: it is of ICtCp colours, and so is no alternative here.

#include <variant>

#include "core/named_value.h"
#include "spectrum/cie76_difference.h"
#include "spectrum/cie94_difference.h"
#include "spectrum/ciede2000_difference.h"
#include "spectrum/cmc_difference.h"

namespace emulsion {

/// All differences of CIELAB colours; the first is the default.
using ColorDifference =
    std::variant<Ciede2000Difference, Cie76Difference, Cie94GraphicDifference, Cie94TextileDifference, CmcDifference>;

/// \param method with parameters in their ranges, as parse_named gives and validate_named checks
[[nodiscard]] inline double difference(const ColorDifference& method, const Lab& reference,
                                       const Lab& sample) noexcept {
    return visit_noexcept([&](const auto& chosen) { return difference(chosen, reference, sample); }, method);
}

}  // namespace emulsion
