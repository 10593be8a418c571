#pragma once
// Histogram adjustment with the ceiling of human contrast sensitivity.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// adjusted_histogram() with the ceiling dLd / dY <= T(Ld) / T(Y), T = detection_threshold_cdm2(): what cannot be told
/// apart in the world cannot be told apart on the display, so that dark scenes come out dark. Needs luminances in
/// cd/m^2. Source: Ward Larson, Rushmeier & Piatko 1997 (histogram_adjustment.h), section on human contrast
/// sensitivity. Departs from it in that contrast is held below linear as well, which that ceiling alone does not do
/// where the display is darker than the world. What needs less than the display's range comes out linear, T(peak / 2) /
/// T(Ya) Y / peak as in Ward 1994 (see ContrastScale), but no brighter than to bring the robust largest luminance to
/// white.
struct HistogramHuman {
    static constexpr std::string_view kName = "histogram-human";
    static constexpr std::string_view kHelp = "histogram adjustment, visible is what would be; needs cd/m^2";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::absolute};
    float peak = 100.0f;      ///< luminance of display white, cd/m^2; finite, > 0
    float contrast = 100.0f;  ///< of display white over its black; finite, > 1
    bool operator==(const HistogramHuman&) const = default;

    static constexpr std::array kParameters = {
        Parameter<HistogramHuman>{"peak", &HistogramHuman::peak, kPositiveFinite, "cd/m^2",
                                  "luminance of display white"},
        Parameter<HistogramHuman>{"contrast",
                                  &HistogramHuman::contrast,
                                  {1.0, kInfinity, RangeEnd::open, RangeEnd::open},
                                  "",
                                  "of the display, white over black"}};
};

[[nodiscard]] Adaptation own_adaptation(const HistogramHuman& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const HistogramHuman& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
