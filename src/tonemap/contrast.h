#pragma once
// Keeping what can just be seen.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Smallest difference from a background of `adaptation_cdm2` that an eye adapted to it can see, in cd/m^2:
/// 0.0594 (1.219 + Ya^0.4)^2.5. Source: Ward 1994 (below), eq. 4, from the data of Blackwell 1946.
[[nodiscard]] double just_noticeable_difference_cdm2(double adaptation_cdm2) noexcept;

/// Ld = s Y / peak, s = ((1.219 + Yda^0.4) / (1.219 + Ya^0.4))^2.5, Yda = peak / 2: one scale for the picture, so that
/// a difference that is just visible in the world is just visible on the display. Needs luminances in cd/m^2. Source:
/// Ward, "A Contrast-Based Scalefactor for Luminance Display", Graphics Gems IV, 1994, eq. 7.
struct ContrastScale {
    static constexpr std::string_view kName = "contrast";
    static constexpr std::string_view kHelp = "linear, just visible differences stay just visible; needs cd/m^2";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::absolute};
    float peak = 100.0f;  ///< luminance of display white, cd/m^2; finite, > 0
    bool operator==(const ContrastScale&) const = default;

    static constexpr std::array kParameters = {Parameter<ContrastScale>{"peak", &ContrastScale::peak, kPositiveFinite,
                                                                        "cd/m^2", "luminance of display white"}};
};

[[nodiscard]] Adaptation own_adaptation(const ContrastScale& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const ContrastScale& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
