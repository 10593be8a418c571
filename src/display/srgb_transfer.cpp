#include "display/srgb_transfer.h"

#include <cmath>

#include "display/curve_table.h"

namespace emulsion {

namespace {

constexpr double kSlope = 12.92;
constexpr double kScale = 1.055;
constexpr double kOffset = 0.055;
constexpr double kExponent = 2.4;
constexpr double kLinearKnee = 0.0031308;
constexpr double kEncodedKnee = 0.04045;

/// 1.055 x^(1/2.4) - 0.055, put so that 1 is met exactly in double precision.
double encode_above_knee(double linear) noexcept { return 1.0 + kScale * (std::pow(linear, 1.0 / kExponent) - 1.0); }

}  // namespace

double encode(const SrgbTransfer& /*transfer*/, double linear) noexcept {
    if (linear <= kLinearKnee) return kSlope * linear;
    return encode_above_knee(linear);
}

double decode(const SrgbTransfer& /*transfer*/, double encoded) noexcept {
    if (encoded <= kEncodedKnee) return encoded / kSlope;
    return std::pow((encoded + kOffset) / kScale, kExponent);
}

void encode(const SrgbTransfer& /*transfer*/, std::span<RGB> linear) noexcept {
    constexpr auto kKnee = static_cast<float>(kLinearKnee);
    constexpr auto kSlopeF = static_cast<float>(kSlope);
    static const CurveTable above_knee(encode_above_knee, kKnee);
    const auto encoded = [](float x) noexcept { return x <= kKnee ? kSlopeF * x : above_knee(x); };
    for (RGB& rgb : linear) rgb = {encoded(rgb.r), encoded(rgb.g), encoded(rgb.b)};
}

}  // namespace emulsion
