#pragma once

#include <array>
#include <string_view>

#include "film/filter_parameters.h"

namespace emulsion {

/// sinc(x) sinc(x / tau): a sinc under a Lanczos window. sinc(x) = sin(pi x)/(pi x), zeros at whole pixels.
/// Source: Duchon, "Lanczos Filtering in One and Two Dimensions", J. Appl. Meteor. 18 (1979).
struct LanczosSincFilter {
    static constexpr std::string_view kName = "sinc";
    static constexpr std::string_view kHelp = "a sinc under a Lanczos window";
    float x_radius_px = 4.0f;  ///< finite, > 0
    float y_radius_px = 4.0f;  ///< finite, > 0
    float tau = 3.0f;          ///< where the window first reaches 0, in pixels; finite, > 0
    bool operator==(const LanczosSincFilter&) const = default;

    static constexpr std::array kParameters = {
        x_radius_parameter(&LanczosSincFilter::x_radius_px), y_radius_parameter(&LanczosSincFilter::y_radius_px),
        Parameter<LanczosSincFilter>{"tau", &LanczosSincFilter::tau, kPositiveFinite, "px",
                                     "where the window first reaches 0"}};
};

/// 1-D weight at |offset_px| < radius_px.
[[nodiscard]] double eval_inside(const LanczosSincFilter& filter, double offset_px, double radius_px) noexcept;

}  // namespace emulsion
