#include "tonemap/scene_luminance.h"

#include <algorithm>
#include <cmath>

namespace emulsion {

namespace {

/// How many of `count` values lie beyond each robust end.
double outliers(double count) noexcept {
    const double share = std::floor(count / 1000.0);
    return share == 0.0 && count >= 64.0 ? 1.0 : share;
}

}  // namespace

double SceneLuminance::quantile_cdm2(double q) const noexcept {
    const double value = histogram().value_of_rank(q * static_cast<double>(histogram().total()));
    return std::clamp(value, statistics_.min_positive_cdm2, statistics_.max_cdm2);
}

// Of the values themselves the rank is a half more than how many are less: a whole one may lie in the gap between an
// outlier and the others.
double SceneLuminance::robust_min_cdm2() const noexcept {
    const auto count = static_cast<double>(histogram().total());
    const double outside = outliers(count);
    return outside == 0.0 ? statistics_.min_positive_cdm2 : quantile_cdm2((outside + 0.5) / count);
}

double SceneLuminance::robust_max_cdm2() const noexcept {
    const auto count = static_cast<double>(histogram().total());
    const double outside = outliers(count);
    return outside == 0.0 ? statistics_.max_cdm2 : quantile_cdm2((count - outside - 0.5) / count);
}

}  // namespace emulsion
