#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "film/filter_parameters.h"

namespace emulsion {

/// The tent 1 - |x|/radius.
struct TriangleFilter {
    static constexpr std::string_view kName = "triangle";
    static constexpr std::string_view kHelp = "a tent";
    float x_radius_px = 2.0f;  ///< finite, > 0
    float y_radius_px = 2.0f;  ///< finite, > 0
    bool operator==(const TriangleFilter&) const = default;

    static constexpr std::array kParameters = {x_radius_parameter(&TriangleFilter::x_radius_px),
                                               y_radius_parameter(&TriangleFilter::y_radius_px)};
};

/// 1-D weight at |offset_px| < radius_px.
[[nodiscard]] inline double eval_inside(const TriangleFilter&, double offset_px, double radius_px) noexcept {
    return 1.0 - std::abs(offset_px) / radius_px;
}

}  // namespace emulsion
