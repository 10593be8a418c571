#pragma once
// Colour difference of 2000. See spectrum/color_difference.h.

#include <string_view>

#include "spectrum/cielab.h"

namespace emulsion {

/// Lightness, chroma and hue weighed by their means, hue and chroma of blues turned into one another; kL = kC = kH = 1.
/// Symmetric. A grey colour has no hue: the difference in hue is then 0, the mean hue that of the other colour.
/// The mean of two hues is not defined where they are opposite (180 degrees apart): it jumps there, and the difference
/// with it, by about 1 % (4.7461 and 4.8045 for pair 14 of the source). At exactly 180 degrees ours is half the sum of
/// both hues in [0, 360); rounding of the hues decides which side a pair falls on that is opposite but for rounding.
/// Source: CIE 142-2001; Sharma, Wu & Dalal, "The CIEDE2000 color-difference formula", Color Res. Appl. 30(1), 2005,
/// eq. 2-22.
struct Ciede2000Difference {
    static constexpr std::string_view kName = "ciede2000";
    static constexpr std::string_view kHelp = "CIE 2000, the CIE's recommendation";
    bool operator==(const Ciede2000Difference&) const = default;
};

[[nodiscard]] double difference(const Ciede2000Difference& method, const Lab& reference, const Lab& sample) noexcept;

}  // namespace emulsion
