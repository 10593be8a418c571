#include "tonemap/detection_threshold.h"

#include <cmath>

namespace emulsion {

double detection_threshold_cdm2(double adaptation_cdm2) noexcept {
    const double log_adaptation = std::log10(adaptation_cdm2);
    const auto log_threshold = [&] {
        if (log_adaptation < -3.94) return -2.86;
        if (log_adaptation < -1.44) return std::pow(0.405 * log_adaptation + 1.6, 2.18) - 2.86;
        if (log_adaptation < -0.0184) return log_adaptation - 0.395;
        if (log_adaptation < 1.9) return std::pow(0.249 * log_adaptation + 0.65, 2.7) - 0.72;
        return log_adaptation - 1.255;
    };
    return std::pow(10.0, log_threshold());
}

}  // namespace emulsion
