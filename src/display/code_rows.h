#pragma once
// The inner loops of rounding to codes where every component is rounded by itself.

#include <cstdint>
#include <span>

#include "display/code_value.h"

namespace emulsion {

/// A fraction of a code in units of 2^-16. A value is rounded up if its fraction of a code and the threshold come to a
/// code or more, so that the mean of many pixels is that of their values where thresholds are evenly spread.
using Threshold = std::uint16_t;

/// codes[i] is the code nearest to encoded[i], halves up.
void round_to_nearest(std::span<const float> encoded, const CodeScale& scale, std::span<std::uint16_t> codes) noexcept;

/// codes[i] is encoded[i] in units (display/code_units.h) and thresholds[i], rounded down. The three have one size.
void round_by_thresholds(std::span<const float> encoded, std::span<const Threshold> thresholds, const CodeScale& scale,
                         std::span<std::uint16_t> codes) noexcept;

/// The same with two uniform numbers of a code each. Their sum less a code is triangular noise, and half a code more
/// makes rounding down one to nearest; an odd unit makes it symmetric about 0 but for half a unit. Within half a code
/// of either end, `first` alone. The four have one size.
void round_with_triangular_noise(std::span<const float> encoded, std::span<const Threshold> first,
                                 std::span<const Threshold> second, const CodeScale& scale,
                                 std::span<std::uint16_t> codes) noexcept;

}  // namespace emulsion
