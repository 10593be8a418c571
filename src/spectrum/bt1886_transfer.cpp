#include "spectrum/bt1886_transfer.h"

#include <cmath>

#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

constexpr double kExponent = Bt1886Transfer::kExponent;

/// Luminance of black over that of white, encoded by the bare power. With it the standard's a and b cancel down to
/// a / white = (1 - black)^2.4 and b = black / (1 - black).
double encoded_black(const Bt1886Transfer& transfer) noexcept {
    return std::pow(transfer.black_cdm2 / transfer.white_cdm2, 1.0 / kExponent);
}

}  // namespace

double encode(const Bt1886Transfer& transfer, double linear) noexcept {
    const double black = encoded_black(transfer);
    const double power = odd(linear, [](double x) noexcept { return std::pow(x, 1.0 / kExponent); });
    return (power - black) / (1.0 - black);
}

double decode(const Bt1886Transfer& transfer, double encoded) noexcept {
    const double black = encoded_black(transfer);
    const double power = encoded * (1.0 - black) + black;
    return odd(power, [](double v) noexcept { return std::pow(v, kExponent); });
}

}  // namespace emulsion
