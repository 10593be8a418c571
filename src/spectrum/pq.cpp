#include "spectrum/pq.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

constexpr double kM1 = 2610.0 / 16384.0;
constexpr double kM2 = 2523.0 / 32.0;
constexpr double kC1 = 107.0 / 128.0;
constexpr double kC2 = 2413.0 / 128.0;
constexpr double kC3 = 2392.0 / 128.0;

}  // namespace

double encode(const PqTransfer& /*transfer*/, double linear) noexcept {
    return odd(linear, [](double x) noexcept {
        const double y = std::pow(x, kM1);
        const double ratio = std::isinf(y) ? kC2 / kC3 : (kC1 + kC2 * y) / (1.0 + kC3 * y);
        return std::pow(ratio, kM2);
    });
}

double decode(const PqTransfer& /*transfer*/, double encoded) noexcept {
    return odd(encoded, [](double v) noexcept {
        const double ratio = std::pow(v, 1.0 / kM2);
        const double divisor = kC2 - kC3 * ratio;
        if (divisor <= 0.0) return std::numeric_limits<double>::infinity();
        return std::pow(std::max(ratio - kC1, 0.0) / divisor, 1.0 / kM1);  // NaN if the ratio is
    });
}

}  // namespace emulsion
