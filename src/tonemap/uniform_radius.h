#pragma once
// Adaptation to a neighbourhood of the same size everywhere.

#include <array>
#include <string_view>

#include "core/image.h"
#include "core/parameters.h"

namespace emulsion {

/// The luminance under a Gaussian whose standard deviation is half of the radius. Across an edge between dark and
/// bright, both sides count: dark pixels next to it come out darker, bright ones brighter, the halo that this
/// adaptation is known for. Source: Pharr & Humphreys, "Physically Based Rendering", 1st ed. 2004, section 8.4 (local
/// adaptation of uniform radius).
struct UniformRadiusAdaptation {
    static constexpr std::string_view kName = "uniform-radius";
    static constexpr std::string_view kHelp = "a neighbourhood of the same size for all pixels; shows halos";
    float radius = 0.05f;  ///< two standard deviations, of the shorter side; in (0, 1]
    bool operator==(const UniformRadiusAdaptation&) const = default;

    static constexpr std::array kParameters = {Parameter<UniformRadiusAdaptation>{"radius",
                                                                                  &UniformRadiusAdaptation::radius,
                                                                                  {0.0, 1.0, RangeEnd::open},
                                                                                  "of the shorter side",
                                                                                  "radius of the neighbourhood"}};
};

/// Over the log-average, as the picture given (relative_luminance.h). Within the tolerance of tone_map_reference() of
/// its twin; the same bits for every number of threads (0: all). \throws std::invalid_argument if threads < 0.
[[nodiscard]] Image<float> local_luminance(const UniformRadiusAdaptation& adaptation, Image<float> relative_luminance,
                                           int threads);
[[nodiscard]] Image<double> local_luminance_reference(const UniformRadiusAdaptation& adaptation,
                                                      const Image<double>& relative_luminance);

}  // namespace emulsion
