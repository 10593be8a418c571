#pragma once
// How much of a sample counts: all of it, less under a LuminanceClamp, or nothing.

#include <cmath>

#include "film/sensor.h"

namespace emulsion {

/// 1 as a rule; what brings the luminance down to `max_luminance` (cd/m^2 times the imaging ratio; > 0, may be
/// infinite) if it is above; 0 for samples that are kept out: with a NaN, an infinity or a negative luminance.
[[nodiscard]] inline float kept_share(const SensorSample& sample, float max_luminance) noexcept {
    // Sums of floats cannot overflow a double.
    const bool all_finite = std::isfinite((static_cast<double>(sample.xyz.x) + static_cast<double>(sample.xyz.y)) +
                                          (static_cast<double>(sample.xyz.z) + static_cast<double>(sample.luminance)));
    if (!all_finite || sample.luminance < 0.0f) return 0.0f;
    return sample.luminance <= max_luminance ? 1.0f : max_luminance / sample.luminance;
}

}  // namespace emulsion
