#include "spectrum/gamma_transfer.h"

#include <cmath>

#include "spectrum/odd_extension.h"

namespace emulsion {

double encode(const GammaTransfer& transfer, double linear) noexcept {
    return odd(linear, [&](double x) noexcept { return std::pow(x, 1.0 / transfer.exponent); });
}

double decode(const GammaTransfer& transfer, double encoded) noexcept {
    return odd(encoded, [&](double v) noexcept { return std::pow(v, transfer.exponent); });
}

}  // namespace emulsion
