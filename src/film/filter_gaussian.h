#pragma once

#include <array>
#include <string_view>

#include "film/filter_parameters.h"

namespace emulsion {

/// A Gaussian less its value at the radius, so that it ends at 0.
struct GaussianFilter {
    static constexpr std::string_view kName = "gaussian";
    static constexpr std::string_view kHelp = "a Gaussian, lowered to end at 0";
    float x_radius_px = 1.5f;  ///< finite, > 0
    float y_radius_px = 1.5f;  ///< finite, > 0
    float sigma_px = 0.5f;     ///< standard deviation before the cut; finite, > 0
    bool operator==(const GaussianFilter&) const = default;

    static constexpr std::array kParameters = {
        x_radius_parameter(&GaussianFilter::x_radius_px), y_radius_parameter(&GaussianFilter::y_radius_px),
        Parameter<GaussianFilter>{"sigma", &GaussianFilter::sigma_px, kPositiveFinite, "px",
                                  "standard deviation before it is lowered"}};
};

/// 1-D weight at |offset_px| < radius_px.
[[nodiscard]] double eval_inside(const GaussianFilter& filter, double offset_px, double radius_px) noexcept;

}  // namespace emulsion
