#pragma once
// The brightest pixel to display white.

#include <string_view>

#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Ld = Y / max(Y): linear, the largest finite luminance becomes 1. One very bright pixel makes all others dark: that
/// is the method. Source: Pharr & Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4.
struct MaxToWhite {
    static constexpr std::string_view kName = "max-to-white";
    static constexpr std::string_view kHelp = "linear, the brightest pixel becomes display white";
    static constexpr OperatorTraits kTraits = {.outliers = OutlierEffect::darkens_all};
    bool operator==(const MaxToWhite&) const = default;
};

[[nodiscard]] Adaptation own_adaptation(const MaxToWhite& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const MaxToWhite& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
