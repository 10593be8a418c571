#include "tonemap/visual_capacity.h"

#include <cmath>

namespace emulsion {

double visual_capacity(double luminance_cdm2) noexcept {
    // Thresholds, or thresholds over luminance, in each of the intervals; where they meet; capacities there.
    static const double dark = std::pow(10.0, -2.86), dim = std::pow(10.0, -0.395), bright = std::pow(10.0, -1.255);
    static const double first = std::pow(10.0, -2.465), last = std::pow(10.0, 0.86);
    static const double at_first = first / dark;
    static const double at_one = at_first - std::log(first) / dim;
    static const double at_last = at_one + (last - 1.0) / dim;
    if (luminance_cdm2 < first) return luminance_cdm2 / dark;
    if (luminance_cdm2 < 1.0) return at_first + std::log(luminance_cdm2 / first) / dim;
    if (luminance_cdm2 < last) return at_one + (luminance_cdm2 - 1.0) / dim;
    return at_last + std::log(luminance_cdm2 / last) / bright;
}

double printed_visual_capacity(double luminance_cdm2) noexcept {
    if (luminance_cdm2 < 0.0034) return luminance_cdm2 / 0.0014;
    if (luminance_cdm2 < 1.0) return 2.4483 + std::log(luminance_cdm2 / 0.0034) / 0.4027;
    if (luminance_cdm2 < 7.2444) return 16.563 + (luminance_cdm2 - 1.0) / 0.4027;
    return 32.0693 + std::log(luminance_cdm2 / 7.2444) / 0.0556;
}

}  // namespace emulsion
