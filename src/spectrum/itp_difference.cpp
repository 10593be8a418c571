#include "spectrum/itp_difference.h"

#include <cmath>

namespace emulsion {

double difference(const ItpDifference& /*method*/, const ICtCp& reference, const ICtCp& sample) noexcept {
    const double di = reference.i - sample.i, dt = 0.5 * (reference.ct - sample.ct), dp = reference.cp - sample.cp;
    return 720.0 * std::sqrt(di * di + dt * dt + dp * dp);
}

}  // namespace emulsion
