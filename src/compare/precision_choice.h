#pragma once
// Fast or reference for the stages up to tone mapping, by what the fast way gets wrong in this picture: measured on the
// picture made smaller, as the reference's time grows with the pixels, and that of bloom and vision with their square.
//
// Both ways go through bloom, vision and tone mapping of the pipeline. CIEDE2000 is between what they give the display,
// display-relative XYZ under the display's white: what is brighter than white is brought to it
// (spectrum/viewing_conditions.h).
//
// What a small picture can't see: edges and light sources smaller than its pixels; what depends on a number of pixels
// (some local adaptations end at one); and extremes, which averaging takes from the luminances that an operator is
// fitted to. docs/tone-mapping.md has what was predicted, and what came of it.

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "compare/difference_statistics.h"
#include "core/color.h"
#include "core/image.h"
#include "develop/pipeline.h"
#include "spectrum/error_budget.h"

namespace emulsion {

/// The wish for the fast way where its colour error is within the budget.
struct AutoPrecision {
    ErrorBudget budget;
    bool operator==(const AutoPrecision&) const = default;
};

using PrecisionChoice = std::variant<Precision, AutoPrecision>;

/// "fast", "reference", or "auto[:MEAN[,P99]]" as parse_auto() reads it.
/// \throws std::invalid_argument naming what was found and what was expected.
[[nodiscard]] PrecisionChoice parse_precision_choice(std::string_view text);

struct PrecisionLossOptions {
    /// Of the smaller picture, in width and in height; >= 1. Unset: 96 with bloom or vision, else 256.
    std::optional<int> most_px = std::nullopt;
    int threads = 0;  ///< of the fast way; >= 0; 0: one per hardware thread; no result depends on it
};

/// What the fast way gets wrong.
struct PrecisionLoss {
    DifferenceStatistics ciede2000;
    int width_px = 0, height_px = 0;  ///< of the picture that it was measured on
};

/// \param scene XYZ, Y in cd/m^2; bad pixels (tonemap/pixel_class.h) are left out in making it smaller
/// \param pipeline whose own precision does not count
/// \throws std::invalid_argument as develop(), and for options out of their range.
[[nodiscard]] PrecisionLoss precision_loss(const Image<XYZ>& scene, Pipeline pipeline,
                                           const PrecisionLossOptions& options = {});

struct PrecisionDecision {
    Precision precision;
    std::string reason;  ///< "fast: dE00 0.0021 mean, 0.011 p99 on 256x171 pixels, within 1 and 3"
};

/// Fast if that is within the budget. \throws std::invalid_argument for a budget out of its range.
[[nodiscard]] PrecisionDecision decide_precision(const PrecisionLoss& loss, const ErrorBudget& budget);

}  // namespace emulsion
