#include "spectrum/srgb_transfer.h"

#include <cmath>

#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

constexpr double kOffset = 0.055;
constexpr double kScale = SrgbTransfer::kScale;
constexpr double kExponent = SrgbTransfer::kExponent;

}  // namespace

double encode(const SrgbTransfer& transfer, double linear) noexcept {
    return odd(linear, [&](double x) noexcept {
        return x <= SrgbTransfer::kLinearKnee ? SrgbTransfer::kSlope * x : encode_above_knee(transfer, x);
    });
}

double decode(const SrgbTransfer& /*transfer*/, double encoded) noexcept {
    return odd(encoded, [](double v) noexcept {
        return v <= SrgbTransfer::kEncodedKnee ? v / SrgbTransfer::kSlope : std::pow((v + kOffset) / kScale, kExponent);
    });
}

// 1.055 x^(1/2.4) - 0.055, put so that 1 is met exactly in double precision.
double encode_above_knee(const SrgbTransfer& /*transfer*/, double linear) noexcept {
    return 1.0 + kScale * (std::pow(linear, 1.0 / kExponent) - 1.0);
}

}  // namespace emulsion
