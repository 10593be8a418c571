#pragma once
// The brightest pixel to display white.

#include <string_view>

#include "core/color.h"
#include "core/image.h"
#include "tonemap/luminance_statistics.h"

namespace emulsion {

/// Ld = Y / max(Y): linear, the largest finite luminance becomes 1. Independent of the unit of luminance. One very
/// bright pixel makes all others dark: that is the method.
/// Source: Pharr & Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4.
struct MaxToWhite {
    static constexpr std::string_view kName = "max-to-white";
    static constexpr std::string_view kHelp = "linear, the brightest pixel becomes display white";
    bool operator==(const MaxToWhite&) const = default;
};

/// Ld / Y, in 1/(cd/m^2), the same for all luminances; the double-precision twin of apply(). 0 if the picture has no
/// positive pixel.
[[nodiscard]] double luminance_scale(const MaxToWhite& mapper, const LuminanceStatistics& statistics,
                                     double luminance_cdm2) noexcept;

/// As for ReinhardGlobal.
void apply(const MaxToWhite& mapper, const LuminanceStatistics& statistics, ImageView<const XYZ> scene,
           ImageView<XYZ> display, const XYZ& display_white, int threads);

}  // namespace emulsion
