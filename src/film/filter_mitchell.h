#pragma once

#include <array>
#include <string_view>

#include "film/filter_parameters.h"

namespace emulsion {

/// Piecewise cubic k(2x/radius), with negative lobes from radius/2 to the radius where c is large beside b.
/// Source: Mitchell & Netravali, "Reconstruction Filters in Computer Graphics", SIGGRAPH 1988, eq. 8.
struct MitchellFilter {
    static constexpr std::string_view kName = "mitchell";
    static constexpr std::string_view kHelp = "a cubic between blur and ringing";
    float x_radius_px = 2.0f;  ///< finite, > 0
    float y_radius_px = 2.0f;  ///< finite, > 0
    float b = 1.0f / 3.0f;     ///< blur; finite
    float c = 1.0f / 3.0f;     ///< ringing; finite
    bool operator==(const MitchellFilter&) const = default;

    static constexpr std::array kParameters = {
        x_radius_parameter(&MitchellFilter::x_radius_px), y_radius_parameter(&MitchellFilter::y_radius_px),
        Parameter<MitchellFilter>{"b", &MitchellFilter::b, kFinite, "", "blur"},
        Parameter<MitchellFilter>{"c", &MitchellFilter::c, kFinite, "", "ringing"}};
};

/// The member b = 0, c = 1/2 of Mitchell's family: at radius 2 it passes through the samples.
/// Source: Catmull & Rom, "A Class of Local Interpolating Splines", in Computer Aided Geometric Design, 1974; Mitchell
/// & Netravali 1988 for the place in the family.
struct CatmullRomFilter {
    static constexpr std::string_view kName = "catmull-rom";
    static constexpr std::string_view kHelp = "the interpolating cubic: mitchell with b = 0, c = 1/2";
    float x_radius_px = 2.0f;  ///< finite, > 0
    float y_radius_px = 2.0f;  ///< finite, > 0
    bool operator==(const CatmullRomFilter&) const = default;

    static constexpr std::array kParameters = {x_radius_parameter(&CatmullRomFilter::x_radius_px),
                                               y_radius_parameter(&CatmullRomFilter::y_radius_px)};
};

/// 1-D weight at |offset_px| < radius_px.
[[nodiscard]] double eval_inside(const MitchellFilter& filter, double offset_px, double radius_px) noexcept;
[[nodiscard]] double eval_inside(const CatmullRomFilter& filter, double offset_px, double radius_px) noexcept;

}  // namespace emulsion
