#include "spectrum/bt709_transfer.h"

#include <algorithm>
#include <cmath>

#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

constexpr double kScale = Bt709Transfer::kScale;
constexpr double kExponent = Bt709Transfer::kExponent;

}  // namespace

double encode(const Bt709Transfer& transfer, double linear) noexcept {
    return odd(linear, [&](double x) noexcept {
        return x < Bt709Transfer::kLinearKnee ? Bt709Transfer::kSlope * x : encode_above_knee(transfer, x);
    });
}

double decode(const Bt709Transfer& /*transfer*/, double encoded) noexcept {
    return odd(encoded, [](double v) noexcept {
        constexpr double kKnee = Bt709Transfer::kLinearKnee;
        if (v < Bt709Transfer::kSlope * kKnee) return v / Bt709Transfer::kSlope;
        return std::max(std::pow(1.0 + (v - 1.0) / kScale, 1.0 / kExponent), kKnee);  // NaN if the first is
    });
}

// 1.099 x^0.45 - 0.099, put so that 1 is met exactly in double precision.
double encode_above_knee(const Bt709Transfer& /*transfer*/, double linear) noexcept {
    return 1.0 + kScale * (std::pow(linear, kExponent) - 1.0);
}

}  // namespace emulsion
