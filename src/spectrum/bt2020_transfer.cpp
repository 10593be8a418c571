#include "spectrum/bt2020_transfer.h"

#include <cmath>

#include "spectrum/odd_extension.h"

namespace emulsion {

namespace {

constexpr double kScale = Bt2020Transfer::kScale;
constexpr double kExponent = Bt2020Transfer::kExponent;

}  // namespace

double encode(const Bt2020Transfer& transfer, double linear) noexcept {
    return odd(linear, [&](double x) noexcept {
        return x < Bt2020Transfer::kLinearKnee ? Bt2020Transfer::kSlope * x : encode_above_knee(transfer, x);
    });
}

double decode(const Bt2020Transfer& /*transfer*/, double encoded) noexcept {
    return odd(encoded, [](double v) noexcept {
        if (v < Bt2020Transfer::kSlope * Bt2020Transfer::kLinearKnee) return v / Bt2020Transfer::kSlope;
        return std::pow(1.0 + (v - 1.0) / kScale, 1.0 / kExponent);
    });
}

// 1.0993 x^0.45 - 0.0993, put so that 1 is met exactly in double precision.
double encode_above_knee(const Bt2020Transfer& /*transfer*/, double linear) noexcept {
    return 1.0 + kScale * (std::pow(linear, kExponent) - 1.0);
}

}  // namespace emulsion
