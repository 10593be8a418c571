#include "tonemap/visual_capacity.h"

#include <cmath>

namespace emulsion {

double visual_capacity(double luminance_cdm2) noexcept {
    // Thresholds, or thresholds over luminance, in each of the intervals; where they meet; capacities there.
    static const double kDark = std::pow(10.0, -2.86), kDim = std::pow(10.0, -0.395), kBright = std::pow(10.0, -1.255);
    static const double kFirst = std::pow(10.0, -2.465), kLast = std::pow(10.0, 0.86);
    static const double kAtFirst = kFirst / kDark;
    static const double kAtOne = kAtFirst - std::log(kFirst) / kDim;
    static const double kAtLast = kAtOne + (kLast - 1.0) / kDim;
    if (luminance_cdm2 < kFirst) return luminance_cdm2 / kDark;
    if (luminance_cdm2 < 1.0) return kAtFirst + std::log(luminance_cdm2 / kFirst) / kDim;
    if (luminance_cdm2 < kLast) return kAtOne + (luminance_cdm2 - 1.0) / kDim;
    return kAtLast + std::log(luminance_cdm2 / kLast) / kBright;
}

double printed_visual_capacity(double luminance_cdm2) noexcept {
    if (luminance_cdm2 < 0.0034) return luminance_cdm2 / 0.0014;
    if (luminance_cdm2 < 1.0) return 2.4483 + std::log(luminance_cdm2 / 0.0034) / 0.4027;
    if (luminance_cdm2 < 7.2444) return 16.563 + (luminance_cdm2 - 1.0) / 0.4027;
    return 32.0693 + std::log(luminance_cdm2 / 7.2444) / 0.0556;
}

}  // namespace emulsion
