#pragma once

#include <array>
#include <string_view>

#include "film/filter_parameters.h"

namespace emulsion {

/// 1 inside the radius.
struct BoxFilter {
    static constexpr std::string_view kName = "box";
    static constexpr std::string_view kHelp = "the mean over a rectangle";
    float x_radius_px = 0.5f;  ///< half-width of the support; finite, > 0
    float y_radius_px = 0.5f;  ///< half-height of the support; finite, > 0
    bool operator==(const BoxFilter&) const = default;

    static constexpr std::array kParameters = {x_radius_parameter(&BoxFilter::x_radius_px),
                                               y_radius_parameter(&BoxFilter::y_radius_px)};
};

/// 1-D weight at |offset_px| < radius_px.
[[nodiscard]] constexpr double eval_inside(const BoxFilter&, double, double) noexcept { return 1.0; }

}  // namespace emulsion
