#pragma once
// Colour differences of 1994. See spectrum/color_difference.h.

#include <string_view>

#include "spectrum/cielab.h"

namespace emulsion {

/// dE^2 = (dL / kL)^2 + (dC / (1 + K1 C))^2 + (dH / (1 + K2 C))^2 with C the chroma of the reference, kL = 1,
/// K1 = 0.045, K2 = 0.015. Not symmetric: CIE 116 also allows the geometric mean of both chromas for C, which is.
/// Source: CIE 116-1995.
struct Cie94GraphicDifference {
    static constexpr std::string_view kName = "cie94-graphic";
    static constexpr std::string_view kHelp = "CIE 1994 for graphic arts";
    bool operator==(const Cie94GraphicDifference&) const = default;
};

/// The same with kL = 2, K1 = 0.048, K2 = 0.014.
struct Cie94TextileDifference {
    static constexpr std::string_view kName = "cie94-textile";
    static constexpr std::string_view kHelp = "CIE 1994 for textiles, lightness counts half";
    bool operator==(const Cie94TextileDifference&) const = default;
};

[[nodiscard]] double difference(const Cie94GraphicDifference& method, const Lab& reference, const Lab& sample) noexcept;
[[nodiscard]] double difference(const Cie94TextileDifference& method, const Lab& reference, const Lab& sample) noexcept;

}  // namespace emulsion
