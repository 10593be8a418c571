#pragma once
// A base layer with its contrast reduced, and on it the details as they are.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// Ld = (Ya / Ymax)^g Y / Ya: the base Ya, that of bilateral unless chosen otherwise, is compressed in logarithms by
/// g = log10(contrast) / log10(Ymax / Ymin), but never stretched, its brightest becoming display white; detail Y / Ya
/// is kept, and may come out above 1. Source: Durand & Dorsey, "Fast Bilateral Filtering for the Display of
/// High-Dynamic-Range Images", SIGGRAPH 2002, section 6, on contrast reduction. Departs from it in that Ymin and Ymax
/// are the robust ones of SceneLuminance, not those of the base; and in the contrast, for which it has 5: pictures were
/// to be shown without an encoding for displays, under which that is a contrast of 34.
struct Durand {
    static constexpr std::string_view kName = "durand";
    static constexpr std::string_view kHelp = "bilateral base with less contrast, details kept";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::nearly_cancels, .monotone = Monotone::locally};
    float contrast = 50.0f;  ///< of the base between its brightest and its darkest; finite, >= 1
    bool operator==(const Durand&) const = default;

    static constexpr std::array kParameters = {
        Parameter<Durand>{"contrast",
                          &Durand::contrast,
                          {1.0, kInfinity, RangeEnd::closed, RangeEnd::open},
                          "",
                          "of the displayed base, its brightest to its darkest; 5 in the paper"}};
};

[[nodiscard]] Adaptation own_adaptation(const Durand& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const Durand& mapper, const SceneLuminance& luminance, double adaptation_cdm2);

}  // namespace emulsion
