#pragma once
// What every operator comes to, once it has seen a picture: two functions of one number. World luminance Y and
// adaptation luminance Ya are in cd/m^2; scaled luminance L has no unit; display luminance Ld is relative: 1 is display
// white.

#include <functional>
#include <span>

#include "core/color.h"
#include "tonemap/adaptation_luminance.h"
#include "tonemap/scene_luminance.h"

namespace emulsion {

/// L = exposure(Ya) Y;  Ld = L compression(L).
/// Global operators have the same Ya for the whole picture, local ones one for each pixel.
struct ToneReproduction {
    /// L of 1 cd/m^2, in 1/(cd/m^2); finite and >= 0 for every Ya > 0.
    std::function<double(double adaptation_cdm2)> exposure;
    /// Ld / L; finite and >= 0 for every finite L >= 0, at 0 its limit. Empty: 1 for every L.
    std::function<double(double scaled_luminance)> compression = {};

    /// Ld / Y, in 1/(cd/m^2).
    [[nodiscard]] double scale(double luminance_cdm2, double adaptation_cdm2) const {
        const double scaling = exposure(adaptation_cdm2);
        return compression ? scaling * compression(scaling * luminance_cdm2) : scaling;
    }
};

/// Maps pixels of row y from column x0 on, from the scene's to display-relative ones; of any rows in any order, on
/// several threads at a time. The two have one size and may be the same pixels.
using MapStretch = std::function<void(int y, int x0, std::span<const XYZ> scene, std::span<XYZ> display)>;

/// Makes ready to scale every pixel; bad pixels as tone_map() says. In single precision, the functions by tables of 64
/// knots an octave (LuminanceTable), or exactly where single precision does not reach. The picture has positive pixels.
/// \throws std::invalid_argument if threads < 0.
[[nodiscard]] MapStretch reproduce(const ToneReproduction& reproduction, const LuminanceStatistics& statistics,
                                   AdaptationLuminance adaptation, const XYZ& display_white, int threads);

}  // namespace emulsion
