#include "film/filter_sinc.h"

#include <cmath>
#include <numbers>

namespace emulsion {

namespace {

double sinc(double x) noexcept {
    const double pi_x = std::numbers::pi * x;
    // Below, sin(y)/y is 1 - y^2/6: 1 in double precision.
    return std::abs(pi_x) < 1e-8 ? 1.0 : std::sin(pi_x) / pi_x;
}

}  // namespace

double eval_inside(const LanczosSincFilter& filter, double offset_px, double) noexcept {
    return sinc(offset_px) * sinc(offset_px / static_cast<double>(filter.tau));
}

}  // namespace emulsion
