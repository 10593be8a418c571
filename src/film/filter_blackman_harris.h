#pragma once

#include <array>
#include <string_view>

#include "film/filter_parameters.h"

namespace emulsion {

/// The minimum four-term Blackman-Harris window, 1 in the middle and 6e-5 where it ends: a bell without negative lobes,
/// whose sidelobes lie 92 dB below its main lobe. The default radius is ours; pbrt-v4 has no such filter.
/// Source: Harris, "On the Use of Windows for Harmonic Analysis with the Discrete Fourier Transform", Proceedings of
/// the IEEE 66 (1978), table of the Blackman-Harris windows, with the origin moved to the window's middle.
struct BlackmanHarrisFilter {
    static constexpr std::string_view kName = "blackman-harris";
    static constexpr std::string_view kHelp = "a smooth bell with very low sidelobes";
    float x_radius_px = 2.0f;  ///< finite, > 0
    float y_radius_px = 2.0f;  ///< finite, > 0
    bool operator==(const BlackmanHarrisFilter&) const = default;

    static constexpr std::array kParameters = {x_radius_parameter(&BlackmanHarrisFilter::x_radius_px),
                                               y_radius_parameter(&BlackmanHarrisFilter::y_radius_px)};
};

/// 1-D weight at |offset_px| < radius_px.
[[nodiscard]] double eval_inside(const BlackmanHarrisFilter& filter, double offset_px, double radius_px) noexcept;

}  // namespace emulsion
