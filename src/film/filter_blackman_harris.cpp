#include "film/filter_blackman_harris.h"

#include <cmath>
#include <numbers>

namespace emulsion {

double eval_inside(const BlackmanHarrisFilter&, double offset_px, double radius_px) noexcept {
    const double phase = std::numbers::pi * offset_px / radius_px;
    return 0.35875 + 0.48829 * std::cos(phase) + 0.14128 * std::cos(2.0 * phase) + 0.01168 * std::cos(3.0 * phase);
}

}  // namespace emulsion
