#pragma once
// Histogram adjustment with the linear ceiling.

#include <array>
#include <string_view>

#include "core/parameters.h"
#include "tonemap/adaptation.h"
#include "tonemap/operator_traits.h"
#include "tonemap/tone_reproduction.h"

namespace emulsion {

/// adjusted_histogram() with the ceiling d ln(Ld) / d ln(Y) <= 1: nowhere more contrast than linear. The robust largest
/// luminance becomes display white, the robust least 1 / contrast. A range that fits the display comes out linear, the
/// robust largest luminance as white, which is where the curve tends to as the range shrinks to that of the display. It
/// asks for no adaptation, and for ratios of luminances only. Source: Ward Larson, Rushmeier & Piatko 1997
/// (histogram_adjustment.h), section on the linear ceiling.
struct HistogramAdjustment {
    static constexpr std::string_view kName = "histogram";
    static constexpr std::string_view kHelp = "histogram adjustment, nowhere more contrast than linear";
    static constexpr OperatorTraits kTraits = {.unit = UnitOfLuminance::nearly_cancels};
    float contrast = 100.0f;  ///< of display white over its black; finite, > 1
    bool operator==(const HistogramAdjustment&) const = default;

    static constexpr std::array kParameters = {
        Parameter<HistogramAdjustment>{"contrast",
                                       &HistogramAdjustment::contrast,
                                       {1.0, kInfinity, RangeEnd::open, RangeEnd::open},
                                       "",
                                       "of the display, white over black"}};
};

[[nodiscard]] Adaptation own_adaptation(const HistogramAdjustment& mapper) noexcept;
[[nodiscard]] ToneReproduction prepare(const HistogramAdjustment& mapper, const SceneLuminance& luminance,
                                       double adaptation_cdm2);

}  // namespace emulsion
